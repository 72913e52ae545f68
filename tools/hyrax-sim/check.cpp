#include <algorithm>
#include <atomic>
#include <filesystem>
#include <iterator>
#include <new>
#include <set>

#include "tools/app/check/check_report.h"
#include "tools/app/command_line/command_results.h"
#include "tools/app/command_line/options.h"
#include "tools/app/command_line/progress.h"
#include "tools/app/command_line/shell_command.h"
#include "tools/app/command_line/workers.h"
#include "tools/files/path.h"
#include "tools/files/scenario_list.h"
#include "tools/files/scenario_writer.h"
#include "tools/files/text_file.h"
#include "tools/report/page_file.h"
#include "tools/store/golden_file.h"
#include "tools/store/output_guard.h"

namespace hyrax {
namespace {

constexpr std::int64_t kFlings = 1000;

struct CheckRequest {
  std::vector<std::string> files;
  std::string golden_folder;
  std::optional<std::int64_t> jobs;
  std::string junit;
  std::string annotate;
  std::string summary;
  std::string page;
  std::string filter;
  bool lists = false;
  bool takes_last_failed = false;
  bool judges_core_only = false;
  std::string unnoticed_folder;
  std::optional<std::int64_t> flings;
  Printing printing;
};

// Those that are open have a golden file. A library that is red all over costs one child process, not one
// each.
void read_open_goldens(const std::vector<CheckVerdict>& verdicts) {
  std::vector<std::string> paths;
  for (const CheckVerdict& verdict : verdicts)
    if (verdict.is_undecided && verdict.golden && has_golden_file(*verdict.golden))
      paths.push_back(verdict.golden->h5_path);
  read_goldens_ahead(paths);
}

// Each worker checks the next scenario until none is left; verdicts are in the order of the paths. Golden
// files are read, in a child process first, only after the workers have ended; and so are scenarios played
// again for which there was not enough memory.
std::vector<CheckVerdict> check_all(const Core& core, const std::vector<std::string>& paths,
                                    CheckOptions options, std::int64_t jobs) {
  std::vector<CheckVerdict> verdicts(paths.size());
  std::atomic<std::size_t> next = 0;
  std::atomic<std::int64_t> done = 0;
  options.reads_golden = jobs == 1;
  const auto check_one = [&](std::size_t index) {
    try {
      verdicts[index] = check_scenario(core, paths[index], options);
    } catch (const std::bad_alloc&) {
      if (options.reads_golden) throw;
      verdicts[index].is_undecided = true;
    }
  };
  const auto work = [&](const auto& show) {
    for (std::size_t index = next++; index < paths.size(); index = next++) {
      check_one(index);
      if (!verdicts[index].is_undecided) ++done;
      show();
    }
  };
  std::vector<std::jthread> workers =
      start_workers(std::min(jobs, static_cast<std::int64_t>(paths.size())) - 1, [&] { work([] {}); });
  Progress progress("scenarios", static_cast<std::int64_t>(paths.size()));
  work([&] { progress.show(done); });
  workers.clear();
  options.reads_golden = true;
  read_open_goldens(verdicts);
  for (std::size_t index = 0; index < paths.size(); ++index) {
    if (!verdicts[index].is_undecided) continue;
    check_one(index);
    progress.show(++done);
  }
  return verdicts;
}

// GitHub reads both streams; the JSON document has standard output to itself.
void annotate(const CheckReport& report, const CheckRequest& request) {
  if (request.annotate.empty()) return;
  const std::string annotations = github_annotations(report.entries);
  if (!request.printing.is_json)
    print_text("{}", annotations);
  else if (!annotations.empty())
    print_error(annotations.substr(0, annotations.size() - 1));  // It ends the line.
}

struct Selection {
  std::vector<std::string> paths;
  std::vector<CheckVerdict> unreferenced;  // And golden folders that cannot be read.
  std::vector<Failure> unlisted;
  bool has_failed_only = false;  // Only those that failed when the folder was last checked.
};

void narrow(const CheckRequest& request, const LastFailed& last_failed, Selection& selection) {
  const auto has_failed = [&](const std::string& path) { return last_failed.contains(path); };
  selection.has_failed_only = request.takes_last_failed &&
                              (std::ranges::any_of(selection.paths, has_failed) ||
                               std::ranges::any_of(selection.unreferenced, has_failed, &CheckVerdict::path));
  if (request.takes_last_failed && !selection.has_failed_only)
    print_error(
        "hyrax-sim check: --last-failed: no scenario failed when this folder was last checked; all are "
        "checked");
  const auto is_left_out = [&](const std::string& path) {
    return path.find(request.filter) == std::string::npos || (selection.has_failed_only && !has_failed(path));
  };
  std::erase_if(selection.paths, is_left_out);
  std::erase_if(selection.unreferenced, [&](const CheckVerdict& verdict) {
    return verdict.status != CheckStatus::failed && is_left_out(verdict.path);
  });
}

// ERRORS: Failure(bad_input) if there is nothing to report.
Selection select(const CheckRequest& request, const LastFailed& last_failed) {
  Selection selection;
  selection.paths = list_scenarios(request.files, selection.unlisted);
  selection.unreferenced = unreferenced_verdicts(request.files, request.golden_folder);
  narrow(request, last_failed, selection);
  if (!selection.paths.empty() || !selection.unreferenced.empty()) return selection;
  if (!selection.unlisted.empty()) throw selection.unlisted.front();
  const std::string which = selection.has_failed_only ? " that failed when this folder was last checked" : "";
  refuse_input("hyrax-sim check: --filter: no path" + which + " contains it (found " + request.filter + ")");
}

// What keeps scenarios from being found.
void add_failures(const Selection& selection, CommandResults& results) {
  for (const Failure& failure : selection.unlisted) {
    print_error(failure.what());
    results.add(failure.exit_code());
  }
}

ExitCode list(const Selection& selection, const CheckRequest& request) {
  const std::vector<std::string>& paths = selection.paths;
  if (request.printing.is_json)
    print_json(Json::Object{{"scenarios", Json::Array(paths.begin(), paths.end())}});
  else
    for (const std::string& path : paths) print_text("{}\n", printable(path));
  CommandResults results;
  add_failures(selection, results);
  return results.exit_code();
}

// The libraries that are played whole: their folder `scenarios` is an argument.
std::vector<Library> whole_libraries(const CheckRequest& request, bool has_failed_only) {
  std::vector<Library> whole;
  if (!request.filter.empty() || has_failed_only) return whole;
  for (const std::string& argument : request.files)
    for (Library& library : libraries_of({argument}, request.golden_folder)) {
      std::error_code unknown;
      if (is_folder(argument) && std::filesystem::equivalent(argument, library.scenarios_folder, unknown))
        whole.push_back(std::move(library));
    }
  return whole;
}

// DIR/NAME.json of each scenario that shows an unnoticed difference.
void write_unnoticed(const std::vector<const CoreVerdict*>& cores, const std::string& folder) {
  if (folder.empty()) return;
  std::vector<std::pair<std::string, const Scenario*>> scenarios;  // With their paths; one may show several.
  for (const CoreVerdict* const core : cores)
    for (const UnnoticedDifference& unnoticed : core->unnoticed)
      if (unnoticed.scenario) {
        const std::string path = folder + "/" + unnoticed.scenario->name + ".json";
        const auto has_path = [&path](const auto& other) { return other.first == path; };
        if (std::ranges::none_of(scenarios, has_path)) scenarios.emplace_back(path, &*unnoticed.scenario);
      }
  for (const auto& [path, scenario] : scenarios)
    if (is_there(path))
      refuse_input("hyrax-sim check: --unnoticed: exists already (found " + path +
                   "); nothing written; name another folder");
  std::error_code error;
  if (!scenarios.empty()) std::filesystem::create_directories(folder, error);
  for (const auto& [path, scenario] : scenarios) {
    write_text_file(path, scenario_file_text(*scenario));
    print_error(path + ": written");
  }
}

// Nothing but the core: no scenario is compared with its golden file.
ExitCode check_core(const CheckRequest& request, CoreChecks cores) {
  const std::vector<Library> libraries = libraries_of(request.files, request.golden_folder);
  if (libraries.empty())
    refuse_input("hyrax-sim check: --core: needs a folder named scenarios, or a folder and --golden (found " +
                 request.files.front() + ")");
  cores.judge_differences(libraries, request.flings.value_or(kFlings));
  Json::Array documents;
  CommandResults results;
  for (const CoreVerdict* const verdict : cores.verdicts()) {
    documents.push_back(core_json(*verdict));
    const bool is_missing = verdict->status == CoreStatus::none && verdict->exit_code == ExitCode::agreed;
    results.add(is_missing ? ExitCode::golden_missing : verdict->exit_code);
    if (request.printing.is_json) continue;
    const bool is_alone = libraries.size() == 1;
    if (verdict->status == CoreStatus::accepted)
      print_text("core{}: the accepted one\n", is_alone ? "" : " of " + printable(verdict->golden_folder));
    print_text("{}", core_text(*verdict, is_alone));
  }
  if (request.printing.is_json) print_json(Json::Object{{"cores", std::move(documents)}});
  write_unnoticed(cores.verdicts(), request.unnoticed_folder);
  return results.exit_code();
}

std::string command_of(const CheckReport& report, const CheckRequest& request) {
  std::vector<std::string> words = {"check"};
  for (const std::string& argument : report.arguments) words.push_back(as_argument(argument));
  if (!report.golden_folder.empty())
    words.insert(words.end(), {"--golden", as_argument(report.golden_folder)});
  words.insert(words.end(), {"--report", as_argument(request.page)});
  return program_command(words);
}

ExitCode check(const Core& core, CheckRequest& request) {
  const std::vector<std::string> arguments = request.files;
  const std::string golden_folder = request.golden_folder;
  const bool asks_for_scenarios =
      request.lists || request.takes_last_failed ||
      !(request.filter + request.junit + request.annotate + request.summary + request.page).empty();
  if (request.judges_core_only && asks_for_scenarios)
    refuse_input(
        "hyrax-sim check: --core: not with --filter, --list, --last-failed, --junit, --annotate, --summary "
        "or "
        "--report");
  set_default_folders(request.files, request.golden_folder);
  if (!request.unnoticed_folder.empty())
    OutputGuard({}, request.golden_folder)
        .admit("hyrax-sim check: --unnoticed", request.unnoticed_folder + "/unnoticed.json");
  if (request.judges_core_only) return check_core(request, CoreChecks(core, arguments, golden_folder));
  LastFailed last_failed;
  Selection selection = select(request, last_failed);
  if (request.lists) return list(selection, request);
  const std::vector<std::string>& paths = selection.paths;
  OutputGuard guard(paths, request.golden_folder);
  if (!request.junit.empty()) guard.admit("hyrax-sim check: --junit", request.junit);
  if (!request.summary.empty()) guard.admit("hyrax-sim check: --summary", request.summary);
  if (!request.page.empty()) guard.admit_file("hyrax-sim check: --report", request.page, {".html"});
  const std::int64_t jobs = request.jobs.value_or(processors());
  std::vector<CheckVerdict> verdicts =
      check_all(core, paths,
                {.golden_folder = request.golden_folder,
                 .watched_step = request.printing.is_json ? program_step(core) : nullptr},
                jobs);
  std::ranges::move(selection.unreferenced, std::back_inserter(verdicts));
  last_failed.update(verdicts, guard);
  CheckReport report{.verdicts = std::move(verdicts),
                     .unlisted = selection.unlisted,
                     .arguments = arguments,
                     .golden_folder = golden_folder,
                     .cores = CoreChecks(core, arguments, golden_folder)};
  explain(report);
  std::vector<Library> libraries = whole_libraries(request, selection.has_failed_only);
  std::erase_if(libraries, [](const Library& library) { return !is_folder(library.golden_folder); });
  report.cores.judge_differences(libraries, request.flings.value_or(kFlings));
  put_into_words(report);
  if (request.printing.is_json)
    print_json(check_json(report));
  else
    print_check(report, request.printing);
  annotate(report, request);
  CommandResults results;
  add_failures(selection, results);
  for (const CoreVerdict* const verdict : report.cores.verdicts()) results.add(verdict->exit_code);
  results.attempt_after([&] { write_unnoticed(report.cores.verdicts(), request.unnoticed_folder); });
  for (const CheckVerdict& verdict : report.verdicts) {
    if (!verdict.note.empty()) print_error(verdict.note);
    results.add(verdict.exit_code);
  }
  if (!request.junit.empty())
    results.attempt_after([&] { write_text_file(request.junit, junit_text(report.entries)); });
  if (!request.summary.empty())
    results.attempt_after([&] { write_text_file(request.summary, check_markdown(report)); });
  if (!request.page.empty())
    results.attempt_after([&] { write_check_page(report, request.page, command_of(report, request)); });
  return results.exit_code();
}

void declare(Options& options, CheckRequest& request) {
  options.files(request.files,
                {"SCENARIO or DIR", "",
                 "scenario files, or folders of them (default: scenarios). A folder's golden files without a "
                 "scenario are reported as unreferenced (exit code 1)"},
                0, -1);
  options.text(request.golden_folder,
               {"--golden", "DIR", "folder of golden files (default: the `golden` beside `scenarios`)"});
  options.integer(request.jobs, {"--jobs", "N", "scenarios at a time (default: one per core)"}, 1);
  options.text(request.junit, {"--junit", "FILE", "also write the verdicts as JUnit XML"});
  options.choice(request.annotate,
                 {"--annotate", "github", "also print a workflow command for each that does not agree"},
                 {"github"});
  options.text(request.summary, {"--summary", "FILE", "also write the report in Markdown"});
  options.text(request.page, {"--report", "FILE.html",
                              "also write the report as a page, with both paths of the worst "
                              "scenario of each of the first three causes"});
  options.text(request.filter, {"--filter", "TEXT", "only those whose paths contain TEXT"});
  options.flag(request.lists, {"--list", "", "print the paths of the scenarios; play nothing"});
  options.flag(request.takes_last_failed,
               {"--last-failed", "",
                "only those that did not agree when they were last checked from this folder; all, if there "
                "are none. They are recorded in $XDG_CACHE_HOME or ~/.cache"});
  options.flag(request.judges_core_only,
               {"--core", "",
                "only compare the core with the accepted one of golden/core, and look for changes that no "
                "scenario notices; exit code 1 if there is one, 4 if no core is accepted"});
  options.text(request.unnoticed_folder,
               {"--unnoticed", "DIR", "write scenarios that show changes that no scenario notices"});
  options.integer(request.flings,
                  {"--flings", "N", "random flings by both cores where the core changed (default: 1000)"}, 0,
                  1'000'000);
  options.removed("--quick", "leave it out: work that cannot change a verdict is always skipped");
  options.printing(request.printing, "print every scenario, and all contacts that moved, before the causes");
}

}  // namespace

Command check_command() {
  return {.name = "check",
          .summary = "replay scenarios and compare every bit with their golden files",
          .example = "hyrax-sim check\n  hyrax-sim check scenarios/flings --junit check.xml",
          .is_common = true,
          .declare = with_request<CheckRequest>(declare, check)};
}

}  // namespace hyrax
