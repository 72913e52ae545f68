#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <set>

#include "tools/app/command_line/options.h"
#include "tools/app/expect/judged_run.h"
#include "tools/app/library/expect_update.h"
#include "tools/app/library/pruning.h"
#include "tools/described/commands.h"
#include "tools/described/core_verdict.h"
#include "tools/described/judged_run.h"
#include "tools/described/run_text.h"
#include "tools/described/scenario_json.h"
#include "tools/files/path.h"
#include "tools/files/printable.h"
#include "tools/files/scenario_list.h"
#include "tools/files/text_file.h"
#include "tools/store/golden_summary.h"
#include "tools/store/output_guard.h"

namespace hyrax {
namespace {

struct BlessRequest {
  std::vector<std::string> files;
  std::string reason;
  std::string golden_folder;
  std::string accepted = std::string(name_of(DifferenceClass::rounding));
  bool updates_hash = false;
  bool updates_ranges = false;
  bool is_dry_run = false;
  bool prunes = false;
  bool accepts_core_only = false;
  Printing printing;

  // With --prune alone nothing is blessed.
  [[nodiscard]] bool blesses() const { return !prunes || !reason.empty(); }
};

struct Blessing {
  enum class Status { fresh, changed, unchanged, refused, failed };
  DescribedRun run;
  Status status = Status::unchanged;
  std::string files_read = {};  // The state of the scenario and its golden pair when they were read.
  std::optional<DifferenceClass> differs_in = {};  // What has to be accepted.
  std::string unreadable = {};                     // Why the golden file cannot be read; else empty.
  std::optional<std::string> scenario_text = {};   // With its new `expect`, where that changes.

  [[nodiscard]] bool writes_golden_file() const {
    return status == Status::fresh || status == Status::changed;
  }
  [[nodiscard]] bool writes() const {
    return writes_golden_file() || (status == Status::unchanged && scenario_text);
  }
};
using Status = Blessing::Status;

std::string_view name_of(Status status) {
  constexpr std::string_view kNames[] = {"new", "changed", "unchanged", "refused", "failed"};
  return kNames[static_cast<std::size_t>(status)];
}

// What becomes of the accepted core of one golden folder.
struct CoreAcceptance {
  std::string golden_folder;
  AcceptedCore core;
  std::string why_not = {};  // Empty: it is accepted.
};

struct BlessReport {
  std::vector<Blessing> blessings = {};
  Pruning pruning = {};
  std::vector<CoreAcceptance> cores = {};
  bool is_written = false;

  [[nodiscard]] std::int64_t count(Status status) const {
    return std::ranges::count(blessings, status, &Blessing::status);
  }
};

std::string state_of_files(const DescribedRun& run) {
  std::string state;
  for (const std::string& path : {run.path, run.place->h5_path, run.place->txt_path})
    state += is_there(path) ? file_checksum(path) : "none";
  return state;
}

// A golden file that cannot be read is replaced, where its class is accepted.
DescribedRun judge_readable(const DescribedCore& core, const DescribedScenario& scenario, Blessing& blessing,
                            const std::string& golden_folder) {
  const std::string path = blessing.run.path;
  try {
    return judge_run(core, path, scenario, {.golden_folder = golden_folder});
  } catch (const Failure& failure) {
    if (failure.exit_code() != ExitCode::bad_input) throw;
    blessing.unreadable = failure.what();
    DescribedRun run = judge_run(core, path, scenario, {.golden_folder = golden_folder, .compares = false});
    run.has_golden = true;
    return run;
  }
}

// Puts the run's values into `expect`, where they may be updated.
void update_expect(const DescribedCore& core, const BlessRequest& request, const std::string& text,
                   Blessing& blessing) {
  DescribedRun& run = blessing.run;
  if (!run.scenario.expect) return;
  std::string updated = text;
  if (run.scenario.expect->state_hash) updated = with_updated_hash(updated, run.contents.state_hash());
  if (request.updates_ranges) {
    std::vector<Expectation> ranges = run.broken();
    std::erase_if(ranges, std::not_fn(is_updatable_range));
    updated = with_updated_ranges(std::move(updated), ranges);
  }
  if (updated == text) return;
  run.scenario =
      to_described_scenario(core.description, parse_json(updated, run.path), run.path, run.scenario.name);
  run.expectations = judge(core.description, *run.scenario.expect, run.contents.summary);
  require_writable(run.path);
  blessing.scenario_text = std::move(updated);
}

void plan(const DescribedCore& core, const BlessRequest& request, const OutputGuard& guard,
          Blessing& blessing) {
  const std::string path = blessing.run.path;
  blessing.run.place = required_golden_place(path, request.golden_folder);
  const GoldenPlace place = *blessing.run.place;
  for (const std::string& output : {place.h5_path, place.txt_path})
    guard.admit_golden("hyrax-sim bless: --golden", output);
  static_cast<void>(has_golden_file(place));  // Refuses what is no place of a golden file.
  blessing.files_read = state_of_files(blessing.run);
  const std::string text = read_scenario_text(path);
  const DescribedScenario scenario = load_described_scenario(core.description, path);
  blessing.run = judge_readable(core, scenario, blessing, request.golden_folder);
  if (request.updates_hash || request.updates_ranges) update_expect(core, request, text, blessing);
  const DescribedRun& run = blessing.run;
  std::string why;
  for (const std::string& fault : run.faults) why += (why.empty() ? "" : "; ") + fault;
  for (const Expectation& broken : run.broken())
    why += (why.empty() ? "its expectations do not hold; " : "; ") + expectation_text(broken);
  if (!why.empty()) throw Failure(ExitCode::disagreed, path + ": not blessed: " + why);
  if (!blessing.unreadable.empty() ||
      (!run.has_golden && (is_there(place.h5_path) || is_there(place.txt_path)))) {
    blessing.status = Status::changed;
    blessing.differs_in = DifferenceClass::shape;
  } else if (!run.has_golden) {
    blessing.status = Status::fresh;
  } else if (!run.comparison->is_proved) {
    blessing.status = Status::changed;
    if (!run.comparison->has_other_scenario || !run.comparison->fault.empty())
      blessing.differs_in = run.comparison->difference;
  }
  if (blessing.writes_golden_file())
    for (const std::string& output : {place.h5_path, place.txt_path}) require_writable(output);
  const auto accepted = std::ranges::find(kDifferenceClasses, request.accepted,
                                          [](DifferenceClass value) { return hyrax::name_of(value); });
  if (!blessing.differs_in || *blessing.differs_in <= *accepted) return;
  blessing.status = Status::refused;
  blessing.run.exit_code = ExitCode::disagreed;
}

void attempt(Blessing& blessing, const auto& work) {
  const auto failure = failure_of(blessing.run.path, work);
  if (!failure) return;
  blessing.status = Status::failed;
  blessing.run.error = failure->what();
  blessing.run.exit_code = failure->exit_code();
  print_error(blessing.run.error);
}

// Scenarios that share a golden file are refused; one that is given twice is blessed once.
std::vector<Blessing> plan_all(const DescribedCore& core, const BlessRequest& request,
                               const std::vector<std::string>& paths) {
  const OutputGuard guard(paths);
  std::map<std::string, std::string> owners;
  std::vector<Blessing> blessings;
  for (const std::string& path : paths) {
    std::error_code unknown;
    Blessing blessing{.run = {.path = path}};
    const auto place = golden_place(path, request.golden_folder);
    if (place) {
      const auto [entry, is_first] =
          owners.emplace(std::filesystem::weakly_canonical(place->h5_path, unknown).string(), path);
      const std::string& owner = entry->second;
      if (!is_first && std::filesystem::equivalent(owner, path, unknown)) continue;
      if (!is_first)
        attempt(blessing, [&] {
          refuse_input(path + ": has the same golden file as " + owner + " (" + place->h5_path +
                       "); bless them with different --golden DIR");
        });
    }
    if (blessing.status != Status::failed) attempt(blessing, [&] { plan(core, request, guard, blessing); });
    blessing.run.exit_code =
        blessing.writes() || blessing.status == Status::unchanged ? ExitCode::agreed : blessing.run.exit_code;
    blessings.push_back(std::move(blessing));
  }
  return blessings;
}

// Why the whole library does not agree, once the blessings are written; empty: it does.
std::string why_not_agreed(const DescribedCore& core, const BlessRequest& request, const Library& library,
                           const std::vector<Blessing>& blessings) {
  std::set<std::string> blessed;
  std::error_code unknown;
  for (const Blessing& blessing : blessings)
    blessed.insert(std::filesystem::weakly_canonical(blessing.run.path, unknown).string());
  std::vector<std::string> disagreeing;
  const std::vector<std::string> paths = list_scenarios({library.scenarios_folder});
  for (const std::string& path : paths)
    if (!blessed.contains(std::filesystem::weakly_canonical(path, unknown).string()) &&
        judge_file(core, path, request.golden_folder).status != CheckStatus::agreed)
      disagreeing.push_back(path);
  if (disagreeing.empty()) return "";
  return fmt::format("{} of {} scenarios do not agree, the first is {}", disagreeing.size(), paths.size(),
                     disagreeing.front());
}

std::vector<CoreAcceptance> plan_cores(const DescribedCore& core, const BlessRequest& request,
                                       const std::vector<Blessing>& blessings) {
  std::vector<CoreAcceptance> acceptances;
  for (const Library& library : libraries_of(request.files, request.golden_folder)) {
    AcceptedCore accepted = program_core(core);
    accepted.reason = request.reason;
    std::optional<AcceptedCore> before;
    const auto damaged = failure_of("", [&] { before = read_accepted_core(library.golden_folder); });
    if (!damaged && before && before->header == accepted.header && before->files == accepted.files &&
        before->description == accepted.description && before->model == accepted.model)
      continue;
    CoreAcceptance& acceptance = acceptances.emplace_back(CoreAcceptance{library.golden_folder, accepted});
    acceptance.why_not = why_not_agreed(core, request, library, blessings);
    if (before && before->model != accepted.model && request.accepted != "shape")
      acceptance.why_not = fmt::format(
          "the accepted core is of another class (found {}); --accept shape replaces it", before->model);
    require_writable(accepted_core_folder(library.golden_folder) + "/accepted.txt");
  }
  return acceptances;
}

std::string refusal_sentence(const BlessReport& report) {
  if (const auto failed = report.count(Status::failed); failed > 0)
    return fmt::format("hyrax-sim bless: nothing written: {} of {} scenarios failed", failed,
                       report.blessings.size());
  const Blessing* widest = nullptr;
  for (const Blessing& blessing : report.blessings)
    if (blessing.status == Status::refused && (widest == nullptr || blessing.differs_in > widest->differs_in))
      widest = &blessing;
  if (widest == nullptr) return "";
  return fmt::format(
      "hyrax-sim bless: nothing written: {} of {} scenarios differ by more than --accept allows; --accept {} "
      "accepts all of them, the widest of which is {}",
      report.count(Status::refused), report.blessings.size(), hyrax::name_of(*widest->differs_in),
      widest->run.path);
}

void write(const DescribedCore& core, const BlessRequest& request, BlessReport& report) {
  for (const Blessing& blessing : report.blessings)
    if (state_of_files(blessing.run) != blessing.files_read)
      throw Failure(ExitCode::cannot_access, "hyrax-sim bless: nothing written: " + blessing.run.path +
                                                 ": it or its golden file was changed by another program "
                                                 "while it was played; bless again");
  report.is_written = true;
  for (Blessing& blessing : report.blessings)
    if (blessing.writes())
      attempt(blessing, [&] {
        if (blessing.writes_golden_file())
          write_golden_pair(core, blessing.run.scenario, *blessing.run.place, request.reason);
        if (blessing.scenario_text) write_text_file(blessing.run.path, *blessing.scenario_text);
      });
  const bool has_failed = report.count(Status::failed) > 0;
  if (has_failed) report.pruning.removed.clear();
  remove_files(report.pruning.removed);
  for (CoreAcceptance& acceptance : report.cores) {
    if (has_failed && acceptance.why_not.empty())
      acceptance.why_not = "not every golden file could be written";
    if (acceptance.why_not.empty()) write_accepted_core(acceptance.golden_folder, acceptance.core);
  }
}

void print_report(const BlessRequest& request, const BlessReport& report) {
  for (const Blessing& blessing : report.blessings) {
    if (blessing.status == Status::failed ||
        (blessing.status == Status::unchanged && !blessing.scenario_text && !request.printing.is_verbose()))
      continue;
    const auto& comparison = blessing.run.comparison;
    std::string what = blessing.unreadable;
    if (what.empty() && comparison && !comparison->agrees()) what = blessing.run.sentence();
    print_text("{}: {}{}{}\n", printable(blessing.run.path), name_of(blessing.status),
               what.empty() ? "" : ": " + printable(what), blessing.scenario_text ? "; expect changes" : "");
    if (comparison && !comparison->agrees() && request.printing.is_verbose())
      print_text("{}", comparison_text(*comparison));
  }
  if (const auto unchanged = report.count(Status::unchanged); unchanged > 0)
    print_text("{} unchanged\n", unchanged);
  for (const std::string& path : report.pruning.removed)
    print_text("{}: {}\n", printable(path), report.is_written ? "removed" : "has no scenario");
  for (const CoreAcceptance& acceptance : report.cores) {
    const std::string folder = accepted_core_folder(acceptance.golden_folder);
    if (acceptance.why_not.empty())
      print_text("core: {} in {}\n", report.is_written ? "accepted" : "would be accepted", folder);
    else
      print_text("core: not accepted in {}: {}\n", folder, acceptance.why_not);
  }
  if (request.accepts_core_only && report.cores.empty()) print_text("core: accepted already\n");
  if (request.prunes && report.pruning.removed.empty() && report.pruning.left.empty())
    print_text("no golden file without a scenario\n");
  if (request.is_dry_run) print_text("dry run: nothing written\n");
}

Json report_json(const BlessReport& report) {
  Json::Object document;
  for (const Status status :
       {Status::fresh, Status::changed, Status::unchanged, Status::refused, Status::failed})
    document.emplace_back(name_of(status), report.count(status));
  document.emplace_back("written", report.is_written);
  const std::vector<std::string>& removed = report.pruning.removed;
  document.emplace_back("pruned", Json::Array(removed.begin(), removed.end()));
  document.emplace_back("cores", list_of(report.cores, [](const CoreAcceptance& core) {
                          return Json::Object{
                              {"golden", core.golden_folder},
                              {"accepted", core.why_not.empty()},
                              {"why_not", core.why_not.empty() ? Json() : Json(core.why_not)}};
                        }));
  document.emplace_back(
      "results", list_of(report.blessings, [](const Blessing& blessing) {
        Json::Object result{{"scenario", blessing.run.path}, {"status", name_of(blessing.status)}};
        if (blessing.run.comparison)
          std::ranges::move(comparison_json(*blessing.run.comparison), std::back_inserter(result));
        if (!blessing.run.error.empty()) result.emplace_back("error", blessing.run.error);
        return result;
      }));
  return document;
}

void complete(BlessRequest& request) {
  if (request.prunes && request.files.empty()) {
    request.files = {"scenarios"};
    if (request.golden_folder.empty()) request.golden_folder = "golden";
  }
  if (request.accepts_core_only) set_default_folders(request.files, request.golden_folder);
  if (request.files.empty())
    refuse_input("hyrax-sim bless: SCENARIO: at least 1 needed (found 0); see `hyrax-sim bless --help`");
  if (request.blesses() && request.reason.find_first_not_of(" \t\n") == std::string::npos)
    refuse_input(
        "hyrax-sim bless: --reason must say why the golden files change, as in --reason 'wider window'");
  request.reason = printable_lines(request.reason);
  std::ranges::replace(request.reason, '\n', ' ');
}

// All checks come before the first write: if one fails, no golden file is changed.
ExitCode bless(const DescribedCore& core, BlessRequest& request) {
  complete(request);
  BlessReport report;
  if (request.prunes)
    report.pruning = find_prunable(request.files, request.golden_folder,
                                   [&](const std::string& path) { return is_golden_h5(core, path); });
  if (request.blesses() && !request.accepts_core_only)
    report.blessings = plan_all(core, request, list_scenarios(request.files));
  if (request.blesses() && refusal_sentence(report).empty())
    report.cores = plan_cores(core, request, report.blessings);
  const std::string refusal = refusal_sentence(report);
  if (request.accepts_core_only && libraries_of(request.files, request.golden_folder).empty())
    refuse_input(
        "hyrax-sim bless: --core: needs scenarios below a folder named scenarios, or a folder and --golden "
        "(found " +
        request.files.front() + ")");
  if (!refusal.empty()) print_error(refusal);
  if (refusal.empty() && !request.is_dry_run) write(core, request, report);
  if (request.printing.is_json)
    print_json(report_json(report));
  else
    print_report(request, report);
  for (const std::string& path : report.pruning.left)
    print_error(path + ": has no scenario; left, as `bless` did not write it");
  ExitCode exit_code = ExitCode::agreed;
  for (const Blessing& blessing : report.blessings)
    exit_code = more_serious(exit_code, blessing.run.exit_code);
  for (const CoreAcceptance& acceptance : report.cores)
    if (request.accepts_core_only && !acceptance.why_not.empty())
      exit_code = more_serious(exit_code, ExitCode::disagreed);
  return exit_code;
}

void declare(Options& options, BlessRequest& request) {
  std::vector<std::string> class_names;
  for (const DifferenceClass difference : kDifferenceClasses)
    class_names.emplace_back(hyrax::name_of(difference));
  options.files(request.files, {"SCENARIO or DIR", "", "scenario files, or folders of them"}, 0, -1);
  options.text(request.reason, {"--reason", "TEXT", "why they change; recorded in the summary (required)"});
  options.choice(request.accepted,
                 {"--accept", "CLASS",
                  "the widest difference that may be blessed (default: rounding); new scenarios and those "
                  "whose own text changed need none"},
                 class_names);
  options.flag(request.updates_hash, {"--update-hash", "",
                                      "put the new `expect.state_hash` into the scenario files that have "
                                      "one; nothing else in them changes"});
  options.flag(request.updates_ranges,
               {"--update-expect", "",
                "as --update-hash, and new values for counts and ranges of `expect` that do not hold: a "
                "range keeps its width. Booleans, exact values and one-sided limits never change"});
  options.flag(request.is_dry_run, {"--dry-run", "", "show what would change; write nothing"});
  options.flag(
      request.accepts_core_only,
      {"--core", "",
       "only accept this program's core in golden/core, if the whole library agrees (default: scenarios)"});
  options.flag(request.prunes, {"--prune", "",
                                "remove the golden files without a scenario, of the folders given (default: "
                                "scenarios); with --reason bless as well. Refused where no scenario is left "
                                "or something cannot be read; files that `bless` did not write stay"});
  options.text(request.golden_folder,
               {"--golden", "DIR", "folder of golden files (default: the `golden` beside `scenarios`)"});
  options.printing(request.printing, "print what differs in every scenario");
}

}  // namespace

Command described_bless_command(const DescribedCore& core) {
  return {
      .name = "bless",
      .summary = "accept current results as the new golden files, with a reason",
      .example = "hyrax-sim bless scenarios/first.json --reason 'a harder push'\n  hyrax-sim bless --prune",
      .is_common = true,
      .declare = with_request<BlessRequest>(declare,
                                            [&core](BlessRequest& request) { return bless(core, request); })};
}

}  // namespace hyrax
