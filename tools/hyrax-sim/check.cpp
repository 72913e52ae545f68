#include <algorithm>
#include <atomic>
#include <functional>
#include <iterator>
#include <system_error>
#include <thread>

#include "tools/files/path.h"
#include "tools/files/scenario_list.h"
#include "tools/files/text_file.h"
#include "tools/hyrax-sim/check_verdict.h"
#include "tools/hyrax-sim/commands.h"
#include "tools/hyrax-sim/print.h"
#include "tools/hyrax-sim/progress.h"
#include "tools/store/output_guard.h"

namespace hyrax {
namespace {

struct CheckRequest {
  std::vector<std::string> files;
  std::string golden_folder;
  std::optional<std::int64_t> jobs;
  std::string junit;
  bool is_quick = false;  // No verdict depends on it, and `check` leaves out no less work without it.
  bool is_json = false;
};

std::vector<std::string> paths_of(CheckRequest& request) {
  if (request.files.empty()) {
    if (!is_folder("scenarios"))
      throw Failure(ExitCode::bad_input,
                    "scenarios: there is no such folder here; name the scenarios or folders to check");
    request.files = {"scenarios"};
    if (request.golden_folder.empty()) request.golden_folder = "golden";
  }
  return list_scenarios(request.files);
}

// As many as asked for, or as the system allows: those that exist do the work of all.
std::vector<std::jthread> start_workers(std::int64_t count, const std::function<void()>& work) {
  std::vector<std::jthread> workers;
  try {
    for (std::int64_t worker = 0; worker < count; ++worker) workers.emplace_back(work);
  } catch (const std::system_error&) {
  }
  return workers;
}

// Each worker takes the next scenario until none is left; verdicts are in the order of the paths. A golden
// file is read, in a child process first, only after the workers have ended.
std::vector<CheckVerdict> check_all(const std::vector<std::string>& paths, CheckOptions options,
                                    std::int64_t jobs) {
  std::vector<CheckVerdict> verdicts(paths.size());
  std::atomic<std::size_t> next = 0;
  std::atomic<std::int64_t> done = 0;
  options.reads_golden = jobs == 1;
  const auto work = [&] {
    for (std::size_t index = next++; index < paths.size(); index = next++) {
      verdicts[index] = check_scenario(paths[index], options);
      if (!verdicts[index].is_open) ++done;
    }
  };
  std::vector<std::jthread> workers =
      start_workers(std::min(jobs, static_cast<std::int64_t>(paths.size())) - 1, work);
  Progress progress("scenarios", static_cast<std::int64_t>(paths.size()));
  for (std::size_t index = next++; index < paths.size(); index = next++) {
    verdicts[index] = check_scenario(paths[index], options);
    progress.show(verdicts[index].is_open ? done.load() : ++done);
  }
  workers.clear();
  options.reads_golden = true;
  for (CheckVerdict& verdict : verdicts) {
    if (!verdict.is_open) continue;
    verdict = check_scenario(verdict.path, options);
    progress.show(++done);
  }
  return verdicts;
}

// Comes after the verdicts are printed, which nobody is to lose with the file.
ExitCode write_junit(const std::string& path, const std::vector<CheckVerdict>& verdicts) {
  if (path.empty()) return ExitCode::agreed;
  try {
    write_text_file(path, check_junit(verdicts));
    return ExitCode::agreed;
  } catch (const Failure& failure) {
    print_error(failure.what());
    return failure.exit_code();
  }
}

ExitCode check(CheckRequest& request) {
  const std::vector<std::string> paths = paths_of(request);
  if (!request.junit.empty())
    OutputGuard(paths, request.golden_folder).admit("hyrax-sim check: --junit", request.junit);
  const std::int64_t jobs = request.jobs.value_or(std::max(1u, std::thread::hardware_concurrency()));
  std::vector<CheckVerdict> verdicts = check_all(paths, {.golden_folder = request.golden_folder}, jobs);
  std::ranges::move(find_unreferenced(request.files, request.golden_folder), std::back_inserter(verdicts));
  if (request.is_json)
    print_text("{}\n", to_text(check_json(verdicts), {.depth_indented = 2}));
  else
    print_text("{}", check_text(verdicts));
  for (const CheckVerdict& verdict : verdicts)
    if (!verdict.note.empty()) print_error(verdict.note);
  ExitCode exit_code = ExitCode::agreed;
  for (const CheckVerdict& verdict : verdicts) exit_code = more_serious(exit_code, verdict.exit_code);
  return more_serious(exit_code, write_junit(request.junit, verdicts));
}

}  // namespace

Command check_command() {
  return {.name = "check",
          .summary = "replay scenarios and compare every bit with their golden files",
          .example = "hyrax-sim check\n  hyrax-sim check scenarios/flings --junit check.xml",
          .is_common = true,
          .declare = [](Options& options) {
            const auto request = std::make_shared<CheckRequest>();
            options.files(request->files,
                          {"SCENARIO or DIR", "",
                           "scenario files, or folders of them; scenarios/ if left out. For a folder, golden "
                           "files that no scenario "
                           "refers to are reported as unreferenced (exit code 1)"},
                          0, -1);
            options.text(request->golden_folder,
                         {"--golden", "DIR", "golden files; the `golden` beside `scenarios` if left out"});
            options.whole(request->jobs, {"--jobs", "N", "scenarios at a time; one a core if left out"}, 1);
            options.text(request->junit, {"--junit", "FILE", "writes the verdicts as JUnit XML, too"});
            options.flag(
                request->is_quick,
                {"--quick", "", "same verdicts: `check` already skips all work that cannot change one"});
            options.flag(request->is_json, {"--json", "", "one JSON document instead of the table"});
            return [request] { return check(*request); };
          }};
}

}  // namespace hyrax
