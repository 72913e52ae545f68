#include <algorithm>
#include <atomic>
#include <functional>
#include <iterator>

#include "tools/files/scenario_list.h"
#include "tools/files/text_file.h"
#include "tools/hyrax-sim/command_line/options.h"
#include "tools/hyrax-sim/command_line/outcomes.h"
#include "tools/hyrax-sim/command_line/progress.h"
#include "tools/hyrax-sim/command_line/workers.h"
#include "tools/hyrax-sim/golden/check_pictures.h"
#include "tools/hyrax-sim/golden/check_report.h"
#include "tools/store/golden_file.h"
#include "tools/store/output_guard.h"

namespace hyrax {
namespace {

struct CheckRequest {
  std::vector<std::string> files;
  std::string golden_folder;
  std::optional<std::int64_t> jobs;
  std::string junit;
  std::string annotate;
  std::string summary;
  bool is_quick = false;  // No effect: `check` always skips work that cannot change a verdict.
  Printing printing;
};

// Those that are open have a golden file. A library that is red all over costs one child process, not one
// each.
void read_open_goldens(const std::vector<CheckVerdict>& verdicts) {
  std::vector<std::string> paths;
  for (const CheckVerdict& verdict : verdicts)
    if (verdict.is_open) paths.push_back(verdict.golden->h5_path);
  read_goldens_ahead(paths);
}

// Each worker checks the next scenario until none is left; verdicts are in the order of the paths. Golden
// files are read, in a child process first, only after the workers have ended.
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
  read_open_goldens(verdicts);
  for (CheckVerdict& verdict : verdicts) {
    if (!verdict.is_open) continue;
    verdict = check_scenario(verdict.path, options);
    progress.show(++done);
  }
  return verdicts;
}

// GitHub reads both streams; the JSON document has standard output to itself.
void annotate(const CheckReport& report, const CheckRequest& request) {
  if (request.annotate.empty()) return;
  const std::string annotations = github_annotations(report);
  if (!request.printing.is_json)
    print_text("{}", annotations);
  else if (!annotations.empty())
    print_error(annotations);
}

ExitCode check(CheckRequest& request) {
  const std::vector<std::string> arguments = request.files;
  const std::string golden_folder = request.golden_folder;
  set_default_folders(request.files, request.golden_folder);
  const std::vector<std::string> paths = list_scenarios(request.files);
  OutputGuard guard(paths, request.golden_folder);
  if (!request.junit.empty()) guard.admit("hyrax-sim check: --junit", request.junit);
  if (!request.summary.empty()) {
    guard.admit("hyrax-sim check: --summary", request.summary, {".md"});
    for (const std::string& path : picture_paths(request.summary))
      guard.admit("hyrax-sim check: --summary", path);
  }
  const std::int64_t jobs = request.jobs.value_or(processors());
  std::vector<CheckVerdict> verdicts = check_all(paths, {.golden_folder = request.golden_folder}, jobs);
  std::ranges::move(unreferenced_verdicts(request.files, request.golden_folder),
                    std::back_inserter(verdicts));
  const CheckReport report(std::move(verdicts), arguments, golden_folder);
  if (request.printing.is_json)
    print_text("{}\n", to_text(check_json(report), {.depth_indented = 2}));
  else
    print_check(report, request.printing);
  annotate(report, request);
  Outcomes outcomes;
  for (const CheckVerdict& verdict : report.verdicts()) {
    if (!verdict.note.empty()) print_error(verdict.note);
    outcomes.add(verdict.exit_code);
  }
  if (!request.junit.empty())
    outcomes.attempt_after([&] { write_text_file(request.junit, check_junit(report)); });
  if (!request.summary.empty())
    outcomes.attempt_after([&] {
      write_text_file(request.summary, check_markdown(report, write_pictures(report, request.summary)));
    });
  return outcomes.exit_code();
}

}  // namespace

Command check_command() {
  return {
      .name = "check",
      .summary = "replay scenarios and compare every bit with their golden files",
      .example = "hyrax-sim check\n  hyrax-sim check scenarios/flings --junit check.xml",
      .is_common = true,
      .declare = [](Options& options) {
        const auto request = std::make_shared<CheckRequest>();
        options.files(request->files,
                      {"SCENARIO or DIR", "",
                       "scenario files, or folders of them (default: scenarios). A folder's golden files "
                       "without a scenario are reported as unreferenced (exit code 1)"},
                      0, -1);
        options.text(
            request->golden_folder,
            {"--golden", "DIR", "folder of golden files (default: the `golden` beside `scenarios`)"});
        options.integer(request->jobs, {"--jobs", "N", "scenarios at a time (default: one per core)"}, 1);
        options.text(request->junit, {"--junit", "FILE", "also write the verdicts as JUnit XML"});
        options.choice(request->annotate,
                       {"--annotate", "github", "also print a workflow command for each that does not agree"},
                       {"github"});
        options.text(request->summary,
                     {"--summary", "FILE.md",
                      "also write the report in Markdown; beside it, the worst scenario of each of the first "
                      "three causes as a picture (FILE-1.svg ...), and of the first as a page (FILE.html)"});
        options.flag(request->is_quick,
                     {"--quick", "", "no effect: `check` always skips work that cannot change a verdict"});
        options.printing(request->printing,
                         "print every scenario, and all contacts that moved, before the causes");
        return [request] { return check(*request); };
      }};
}

}  // namespace hyrax
