#include "tools/app/library/check_flow.h"

#include <atomic>
#include <chrono>
#include <filesystem>
#include <new>

#include "tools/app/command_line/part.h"
#include "tools/app/command_line/print.h"
#include "tools/app/command_line/shell_command.h"
#include "tools/files/scenario_list.h"
#include "tools/files/text_file.h"
#include "tools/platform/path.h"
#include "tools/report/result_page.h"

namespace hyrax {
namespace {

void narrow(const CheckRequest& request, const LastFailed& last_failed, CheckSelection& selection) {
  const auto has_failed = [&](const std::string& path) { return last_failed.contains(path); };
  selection.has_failed_only =
      request.takes_last_failed &&
      (std::ranges::any_of(selection.paths, has_failed) ||
       std::ranges::any_of(selection.unreferenced, has_failed, &UnreferencedGolden::path));
  if (request.takes_last_failed && !selection.has_failed_only)
    print_error(
        "hyrax-sim check: --last-failed: no scenario failed when this folder was last checked; all are "
        "checked");
  const auto is_left_out = [&](const std::string& path) {
    return path.find(request.filter) == std::string::npos || (selection.has_failed_only && !has_failed(path));
  };
  std::erase_if(selection.paths, is_left_out);
  std::erase_if(selection.unreferenced, [&](const UnreferencedGolden& golden) {
    return golden.error.empty() && is_left_out(golden.path);
  });
}

// What keeps scenarios from being found.
void add_failures(const CheckSelection& selection, CommandResults& results) {
  for (const Failure& failure : selection.unlisted) {
    print_error(failure.what());
    results.add(failure.exit_code());
  }
}

// GitHub reads both streams; the JSON document has standard output to itself.
void annotate(const std::vector<ReportEntry>& entries, const CheckRequest& request) {
  if (request.annotate.empty()) return;
  const std::string annotations = github_annotations(entries);
  if (!request.printing.is_json)
    print_text("{}", annotations);
  else if (!annotations.empty())
    print_error(annotations.substr(0, annotations.size() - 1));  // It ends the line.
}

// Every scenario; opened, it says what is wrong, and which command replays it.
std::vector<RunPanel> panels_of(const CheckReport& report) {
  std::vector<RunPanel> panels;
  for (const ScenarioVerdict* const verdict : report.verdicts) {
    if (!verdict->is_scenario) continue;
    const std::string name(file_name(verdict->path).stem), &path = verdict->path;
    const std::string& sentence = std::ranges::find(report.entries, path, &ReportEntry::name)->sentence;
    std::vector<std::string> command = {"run", as_argument(path)};
    if (!verdict->golden_option.empty())
      command.insert(command.end(), {"--golden", as_argument(verdict->golden_option)});
    command.insert(command.end(), {"--report", as_argument(name + ".html")});
    const bool is_failed = verdict->status == CheckStatus::failed;  // Its sentence begins with the path.
    panels.push_back({.name = name,
                      .status = std::string(name_of(verdict->status)),
                      .picture = verdict->picture,
                      .text = is_failed ? sentence : path + (sentence.empty() ? "" : ": " + sentence),
                      .command = is_failed ? "" : program_command(command)});
  }
  return panels;
}

void write_page(const std::string& path, const CheckReport& report, const std::vector<Figure>& figures) {
  std::vector<ReportEntry> entries;
  for (const ReportEntry& entry : report.entries)
    if (entry.exit_code != ExitCode::agreed) entries.push_back(entry);
  ShownResult page{
      .title = report.counts, .subtitle = "hyrax-sim check", .panels = panels_of(report), .figures = figures};
  for (const Paragraph& paragraph : report.paragraphs)
    page.verdict.text.emplace_back(paragraph.sentence() + (paragraph.subject.empty() ? "" : "\n") +
                                   paragraph.lines);
  if (!entries.empty())
    page.tables.push_back(
        {.name = "not_agreed",
         .long_name = "what does not agree",
         .columns = {column_of("name", "", "scenario, golden file or core", entries, &ReportEntry::name),
                     column_of("verdict", "", "", entries, &ReportEntry::kind),
                     column_of("sentence", "", "what is wrong", entries, &ReportEntry::sentence)}});
  std::vector<std::string> command = {"check"};
  for (const std::string& argument : report.selection.arguments) command.push_back(as_argument(argument));
  if (!report.selection.golden_option.empty())
    command.insert(command.end(), {"--golden", as_argument(report.selection.golden_option)});
  command.insert(command.end(), {"--report", as_argument(path)});
  write_result_page(path, program_command(command), {page});
}

void fail(ScenarioVerdict& verdict, const Failure& failure) {
  verdict.status = CheckStatus::failed;
  verdict.error = failure.what();
  verdict.exit_code = failure.exit_code();
}

}  // namespace

CheckSelection select(CheckRequest& request, const LastFailed& last_failed) {
  CheckSelection selection{request.files, request.golden_folder};
  const bool asks_for_scenarios =
      request.lists || request.takes_last_failed ||
      !(request.filter + request.junit + request.annotate + request.summary + request.page).empty();
  if (request.judges_core_only && asks_for_scenarios)
    refuse_input(
        "hyrax-sim check: --core: not with --filter, --list, --last-failed, --junit, --annotate, --summary "
        "or "
        "--report");
  set_default_folder(request.files);
  if (!request.unnoticed_folder.empty())
    OutputGuard({}, request.golden_folder)
        .admit("hyrax-sim check: --unnoticed", request.unnoticed_folder + "/unnoticed.json");
  if (request.judges_core_only) return selection;
  selection.paths = list_scenarios(request.files, selection.unlisted);
  selection.unreferenced = find_unreferenced(request.files, request.golden_folder);
  narrow(request, last_failed, selection);
  if (!selection.paths.empty() || !selection.unreferenced.empty()) return selection;
  if (!selection.unlisted.empty()) throw selection.unlisted.front();
  const std::string which = selection.has_failed_only ? " that failed when this folder was last checked" : "";
  refuse_input("hyrax-sim check: --filter: no path" + which + " contains it (found " + request.filter + ")");
}

ExitCode list(const CheckSelection& selection, const CheckRequest& request) {
  const std::vector<std::string>& paths = selection.paths;
  if (request.printing.is_json)
    print_json(Json::Object{{"scenarios", Json::Array(paths.begin(), paths.end())}});
  else
    for (const std::string& path : paths) print_text("{}\n", printable(path));
  CommandResults results;
  add_failures(selection, results);
  return results.exit_code();
}

OutputGuard guard_outputs(const CheckSelection& selection, const CheckRequest& request) {
  OutputGuard guard(selection.paths, request.golden_folder);
  if (!request.junit.empty()) guard.admit("hyrax-sim check: --junit", request.junit);
  if (!request.summary.empty()) guard.admit("hyrax-sim check: --summary", request.summary);
  if (!request.page.empty()) guard.admit_file("hyrax-sim check: --report", request.page, {".html"});
  return guard;
}

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

std::vector<Library> required_libraries(const CheckRequest& request) {
  std::vector<Library> libraries = libraries_of(request.files, request.golden_folder);
  if (libraries.empty())
    refuse_input("hyrax-sim check: --core: needs a folder named scenarios, or a folder and --golden (found " +
                 request.files.front() + ")");
  return libraries;
}

void check_all(std::size_t scenarios, const std::optional<std::int64_t>& jobs,
               const std::function<bool(std::size_t index, bool reads_golden)>& check,
               const std::function<void()>& before_reading) {
  const std::int64_t threads = jobs.value_or(processors());
  std::vector<std::uint8_t> is_decided(scenarios);
  std::atomic<std::size_t> next = 0;
  std::atomic<std::int64_t> done = 0;
  const auto check_one = [&](std::size_t index, bool reads_golden) {
    try {
      is_decided[index] = check(index, reads_golden) ? 1 : 0;
    } catch (const std::bad_alloc&) {
      if (reads_golden) throw;
    }
  };
  const auto work = [&](const auto& show) {
    for (std::size_t index = next++; index < scenarios; index = next++) {
      check_one(index, threads == 1);
      if (is_decided[index] != 0) ++done;
      show();
    }
  };
  std::vector<std::jthread> workers =
      start_workers(std::min(threads, static_cast<std::int64_t>(scenarios)) - 1, [&] { work([] {}); });
  Progress progress("scenarios", static_cast<std::int64_t>(scenarios));
  work([&] { progress.show(done); });
  workers.clear();
  before_reading();
  for (std::size_t index = 0; index < scenarios; ++index) {
    if (is_decided[index] != 0) continue;
    check_one(index, true);
    progress.show(++done);
  }
}

void judge_scenario(ScenarioVerdict& verdict, const std::string& golden_option, bool reads_golden,
                    const std::function<void()>& work) {
  verdict.golden_option = golden_option;
  verdict.golden_folder = golden_folder_of(verdict.path, golden_option);
  const auto start = std::chrono::steady_clock::now();
  const auto failure = failure_of(verdict.path, [&] {
    if (verdict.path == "-") refuse_input("-: standard input has no golden file; name a scenario file");
    try {
      work();
      verdict.exit_code = exit_code_of(verdict.status);
    } catch (const std::bad_alloc&) {
      if (reads_golden) throw;
      verdict.is_undecided = true;  // Alone it has more memory.
    }
  });
  if (failure) fail(verdict, *failure);
  verdict.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void judge_unreferenced(ScenarioVerdict& verdict, const UnreferencedGolden& golden) {
  verdict.path = golden.path;
  verdict.is_scenario = false;
  verdict.status = CheckStatus::unreferenced;
  verdict.exit_code = exit_code_of(verdict.status);
  if (!golden.error.empty()) fail(verdict, Failure(ExitCode::cannot_access, golden.error));
}

Json::Object counts_json(const CheckReport& report) {
  Json::Object counts{{"checked", report.scenario_count()}};
  for (const CheckStatus status : {CheckStatus::agreed, CheckStatus::disagreed, CheckStatus::missing,
                                   CheckStatus::failed, CheckStatus::unreferenced})
    counts.emplace_back(name_of(status), report.count(status));
  return counts;
}

CommandResults report_check(const CheckRequest& request, const CheckReport& report, const Json& document,
                            const std::vector<Figure>& figures) {
  if (request.printing.is_json) {
    print_json(document);
  } else {
    if (request.printing.is_verbose()) print_verdicts(report);
    for (Paragraph paragraph : report.paragraphs) {
      if (request.printing.is_quiet()) paragraph.lines.clear();
      print(paragraph);
    }
    print_text("{}\n", report.counts);
  }
  annotate(report.entries, request);
  CommandResults results;
  add_failures(report.selection, results);
  for (const ReportEntry& entry : report.entries) results.add(entry.exit_code);
  if (!request.junit.empty())
    results.attempt_after([&] { write_text_file(request.junit, junit_text(report.entries)); });
  if (!request.summary.empty())
    results.attempt_after([&] {
      write_text_file(request.summary, markdown_text(report.entries, report.paragraphs, report.counts));
    });
  if (!request.page.empty()) results.attempt_after([&] { write_page(request.page, report, figures); });
  return results;
}

void declare_check(Options& options, CheckRequest& request, const std::string& shown,
                   const std::string& core_help) {
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
  options.text(request.page, {"--report", "FILE.html", "also write the report as a page" + shown});
  options.text(request.filter, {"--filter", "TEXT", "only those whose paths contain TEXT"});
  options.flag(request.lists, {"--list", "", "print the paths of the scenarios; play nothing"});
  options.flag(request.takes_last_failed,
               {"--last-failed", "",
                "only those that did not agree when they were last checked from this folder; all, if there "
                "are none. They are recorded in $XDG_CACHE_HOME or ~/.cache"});
  options.flag(request.judges_core_only, {"--core", "", core_help});
}

}  // namespace hyrax
