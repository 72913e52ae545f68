#include <fmt/format.h>

#include <optional>

#include "sim/result/number_text.h"
#include "tools/app/command_line/part.h"
#include "tools/app/sweep/sweep_run.h"
#include "tools/files/text_file.h"
#include "tools/platform/path.h"
#include "tools/store/output_guard.h"

namespace hyrax {
namespace {

constexpr const char* kName = "hyrax-sim sweep";
constexpr const char* kOutputOption = "hyrax-sim sweep: -o";

struct SweepRequest {
  std::vector<std::string> files;
  std::string output;
  std::string part;
  std::optional<std::int64_t> parts;
  std::optional<std::int64_t> threads;
  std::optional<std::int64_t> member;
  bool merges = false;
  bool is_forced = false;
  Printing printing;
};

[[noreturn]] void refuse_request(const std::string& sentence) {
  refuse_input(std::string(kName) + ": " + sentence);
}

// The names of what a sweep keeps, or of what it does not.
std::string names_of(const KeepSet& keep, bool is_kept) {
  std::string names;
  for (std::size_t each = 0; each < kKeepNames.size(); ++each)
    if (keep.has(static_cast<Keep>(each)) == is_kept)
      names.append(names.empty() ? "" : ", ").append(kKeepNames[each]);
  return names;
}

OutputGuard guard_of(const std::string& path, const PlayableSweep& sweep) {
  std::vector<std::string> inputs{path};
  if (!sweep.base_path.empty()) inputs.push_back(sweep.base_path);
  return OutputGuard(inputs);
}

void report(const SweepRequest& request, const std::string& text, Json::Object document) {
  print_text("{}\n", request.printing.is_json ? to_text(Json(std::move(document)), 1) : text);
}

ExitCode write_member(const SweptCore& core, const SweepRequest& request) {
  if (request.output.empty()) refuse_request("--member: needs -o SCENARIO.json");
  const std::string& path = request.files.front();
  const PlayableSweep sweep = core.load(path);
  const std::int64_t members = sweep.contents.plan.members;
  if (*request.member >= members)
    refuse_request(fmt::format("--member: must be 0 .. {} (found {})", members - 1, *request.member));
  guard_of(path, sweep).admit_scenario(kOutputOption, request.output, request.is_forced, {".json"});
  write_text_file(request.output, sweep.member_text(*request.member), request.is_forced);
  report(request, "written: " + request.output,
         Json::Object{{"member", *request.member}, {"scenario", request.output}});
  return ExitCode::agreed;
}

ExitCode merge(const SweptCore& core, const SweepRequest& request) {
  if (request.output.empty()) refuse_request("--merge: needs -o FILE.h5");
  OutputGuard(request.files).admit(kOutputOption, request.output, {".h5"});
  const MergeOutcome outcome = merge_parts(request.files, core.read_contents, request.output);
  for (const std::string& path : outcome.missing) print_error(path + ": is missing; nothing was written");
  if (!outcome.missing.empty()) return ExitCode::golden_missing;
  report(request,
         fmt::format("merged: {} of {}\nwritten: {}", plain_counted(outcome.head.members, "member"),
                     plain_counted(request.files.size(), "part"), request.output),
         Json::Object{{"members", outcome.head.members},
                      {"parts", static_cast<std::int64_t>(request.files.size())},
                      {"output", request.output}});
  return ExitCode::agreed;
}

std::string output_of(const SweepRequest& request, const std::optional<WorkPart>& part) {
  std::string output = request.output;
  if (output.empty()) output = std::string(file_name(request.files.front()).stem) + ".h5";
  return part ? part_path(output, *part) : output;
}

std::string summary_text(const SweepRequest& request, const SweepPlan& sweep, std::int64_t rows,
                         const StepTally& tally, const std::string& output) {
  std::string text = fmt::format("{}: {}", request.files.front(), plain_counted(rows, "member"));
  if (rows != sweep.members) text += fmt::format(" of {}", sweep.members);
  text += fmt::format("\n  steps          {}", tally.steps);
  const std::int64_t left_out = tally.steps - tally.computed;
  if (left_out > 0)
    text += fmt::format("; {} left out, {:.3g} %: at rest, or repeating exactly", left_out,
                        100.0 * static_cast<double>(left_out) / static_cast<double>(tally.steps));
  text += "\n  kept           " + names_of(sweep.keep, true);
  const std::string dropped = names_of(sweep.keep, false);
  if (!dropped.empty()) text += "\n  not computed   " + dropped;
  return text + "\nwritten: " + output;
}

ExitCode compute(const SweptCore& core, const SweepRequest& request) {
  const std::string& path = request.files.front();
  const auto part = choose_part(kName, request.part, request.parts);
  const PlayableSweep sweep = core.load(path);
  EnsembleHead head = core.head;
  head.sweep_text = sweep.text;
  head.members = sweep.contents.plan.members;
  head.part = part.value_or(WorkPart{});
  head.is_part = part.has_value();
  const std::string output = output_of(request, part);
  guard_of(path, sweep).admit(kOutputOption, output, {".h5"});
  const SweepTally tally = compute_sweep(sweep, head, output, request.threads.value_or(processors()));
  const std::int64_t rows = head.part.rows(head.members);
  Json::Object document{{"sweep", path},        {"members", head.members},          {"computed", rows},
                        {"steps", tally.steps}, {"steps_computed", tally.computed}, {"output", output}};
  if (part) {
    document.emplace_back("part", part->index);
    document.emplace_back("parts", part->count);
  }
  if (tally.early_ends > 0) document.emplace_back("ended_early", tally.early_ends);
  report(request,
         request.printing.is_quiet() ? "written: " + output
                                     : summary_text(request, sweep.contents.plan, rows, tally, output),
         std::move(document));
  if (tally.early_ends == 0) return ExitCode::agreed;
  print_error(fmt::format("{}: {} ended early; {}", path, plain_counted(tally.early_ends, "member"),
                          tally.first_early_end));
  return ExitCode::disagreed;
}

ExitCode sweep(const SweptCore& core, const SweepRequest& request) {
  if (request.merges) {
    if (request.member || !request.part.empty() || request.parts || request.threads || request.is_forced)
      refuse_request("--merge: not with --member, --part, --parts, --force or --threads");
    return merge(core, request);
  }
  if (request.files.size() > 1)
    refuse_request(fmt::format("only one sweep allowed (found {})", request.files.size()));
  if (request.is_forced && !request.member)
    refuse_request("--force: only with --member; results are always replaced");
  if (request.member && (!request.part.empty() || request.parts))
    refuse_request("--member: not with --part or --parts");
  return request.member ? write_member(core, request) : compute(core, request);
}

void declare_options(Options& options, SweepRequest& request) {
  options.files(request.files, {"SWEEP.json", "", "the sweep; with --merge, the parts' result files"}, 1, -1);
  options.text(request.output,
               {"-o,--output", "FILE",
                "the result file (default: the sweep's name + .h5, in the current folder); with "
                "--member the scenario file"});
  options.integer(request.threads, {"--threads", "N", "threads (default: one a processor)"}, 1);
  options.text(request.part,
               {"--part", "I/N",
                "play every member i with i mod N = I only, into FILE.part-I-of-N.h5 (default: as a "
                "Slurm array, an MPI launcher or, with --parts, a Kubernetes indexed job says)"});
  options.integer(request.parts, {"--parts", "N", "the number of parts; the part is JOB_COMPLETION_INDEX"},
                  1);
  options.removed("--resume", "use --part and --merge: a part that was stopped is computed again");
  options.integer(request.member, {"--member", "I", "write member I as a scenario, to run it"}, 0);
  options.flag(request.is_forced,
               {"--force", "", "with --member: replace the file (results are always replaced)"});
  options.flag(request.merges, {"--merge", "", "join the parts of a sweep"});
  options.printing(request.printing);
}

}  // namespace

Command sweep_command_of(std::function<SweptCore(const Core& core)> swept) {
  return {.name = "sweep",
          .summary = "play many flings that differ in some numbers, and store selected results of each",
          .example =
              "hyrax-sim sweep sweep.json -o sweep.h5\n"
              "  hyrax-sim sweep sweep.json --member 17 -o member.json\n"
              "  hyrax-sim sweep --merge sweep.part-*.h5 -o sweep.h5",
          .declare = with_request<SweepRequest>(
              declare_options, [swept = std::move(swept)](const Core& core, const SweepRequest& request) {
                return sweep(swept(core), request);
              })};
}

}  // namespace hyrax
