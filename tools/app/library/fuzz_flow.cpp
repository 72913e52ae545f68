#include "tools/app/library/fuzz_flow.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>

#include "sim/result/number_text.h"
#include "tools/app/command_line/part.h"
#include "tools/platform/path.h"
#include "tools/store/output_guard.h"

namespace hyrax {

WorkPart begin_fuzz(const FuzzRequest& request) {
  if (request.time_s && request.runs) refuse_input("hyrax-sim fuzz: --time and --runs: only one allowed");
  const WorkPart part = choose_part("hyrax-sim fuzz", request.part, request.parts).value_or(WorkPart{});
  const std::string path = (std::filesystem::path(request.folder) / "fuzz.json").string();
  OutputGuard({}).admit("hyrax-sim fuzz: -o", path);
  require_writable(path);  // What hours of it find is not lost.
  if (request.printing.is_json || request.printing.is_quiet()) return part;
  print_text("seed {}\n", request.first_seed());
  std::fflush(stdout);  // A core that crashes ends the program: by its seed the run is played again.
  return part;
}

std::string failure_path(const FuzzRequest& request, std::string& name) {
  make_folder(request.folder);
  const std::string stem = name;
  std::string path;
  for (int number = 1; path.empty() || is_there(path); ++number) {
    name = stem + (number == 1 ? "" : fmt::format("-{}", number));
    path = (std::filesystem::path(request.folder) / (name + ".json")).generic_string();
    if (request.folder == ".") path = name + ".json";
  }
  return path;
}

ExitCode end_fuzz(const FuzzRequest& request, const WorkPart& part, const std::string& kind,
                  std::int64_t runs, double elapsed_s, std::uint64_t failing_run,
                  const std::optional<FuzzFinding>& finding, FuzzNote note) {
  const ExitCode exit_code = finding ? ExitCode::disagreed : ExitCode::agreed;
  if (request.printing.is_json) {
    Json::Array failures;
    if (finding) failures.emplace_back(finding->json);
    Json::Object document{{"seed", request.first_seed()},
                          {"part", Json::Object{{"index", part.index}, {"count", part.count}}},
                          {"without", Json::Array(request.without.begin(), request.without.end())},
                          {"runs", runs},
                          {"elapsed_s", elapsed_s},
                          {"failures", std::move(failures)}};
    std::ranges::move(note.json, std::back_inserter(document));
    print_json(std::move(document), 3);
    return exit_code;
  }
  if (!request.printing.is_quiet())
    print_text("{} in {:.1f} s ({} per minute)\n", counted(runs, "run"), elapsed_s,
               with_decimals(static_cast<double>(runs) / elapsed_s * 60.0, 0));
  if (!request.printing.is_quiet()) print_text("{}", note.lines);
  const std::string breaks = fmt::format("breaks {} {}", kind.starts_with('i') ? "an" : "a", kind);
  const std::string holds =
      runs == 0 ? "nothing was tested"
                : fmt::format("{} {}s hold", request.without.empty() ? "all" : "the other", kind);
  if (finding)
    print_text("run {} {}: {}\n{}", failing_run, VerdictWord{breaks, false}, finding->sentence,
               finding->lines);
  else
    print_text("{}\n", VerdictWord{holds, runs > 0});
  return exit_code;
}

void declare_fuzz(Options& options, FuzzRequest& request, const std::string& kind,
                  const std::vector<std::string>& rules) {
  options.seed(request.seed, {"--seed", "N", "which scenarios are drawn (default: 1)"});
  options.time(request.time_s, {"--time", "TIME", "how long, as 60s, 5m or 2h (default: 60s)"});
  options.integer(request.runs, {"--runs", "N", "how many scenarios, instead of a time"}, 1);
  options.choices(request.without, {"--without", "RULE", kind + " that a run may break; may be repeated"},
                  rules, "rule");
  options.removed("--against",
                  "`hyrax-sim check --core` judges another core, hyrax-replay compares platforms");
  options.text(request.part, {"--part", "I/N",
                              "play only the runs k with k mod N = I, 0 <= I < N (default: as SLURM or Open "
                              "MPI says in the environment, else all)"});
  options.integer(request.parts, {"--parts", "N", "the same, with I from JOB_COMPLETION_INDEX"}, 1);
  options.text(
      request.folder,
      {"-o,--output", "DIR",
       "folder for a failing scenario, shrunk, named fuzz-SEED-RUN.json (default: the current one)"});
  options.printing(request.printing);
}

}  // namespace hyrax
