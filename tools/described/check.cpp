#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "tools/app/command_line/command_results.h"
#include "tools/app/command_line/shell_command.h"
#include "tools/app/expect/judged_run.h"
#include "tools/app/library/report_documents.h"
#include "tools/described/commands.h"
#include "tools/described/core_verdict.h"
#include "tools/described/judged_run.h"
#include "tools/described/run_text.h"
#include "tools/described/scenario_json.h"
#include "tools/files/path.h"
#include "tools/files/printable.h"
#include "tools/files/scenario_list.h"
#include "tools/files/text_file.h"
#include "tools/files/unreferenced_golden.h"
#include "tools/store/output_guard.h"

namespace hyrax {
namespace {

struct CheckRequest {
  std::vector<std::string> files;
  std::string golden_folder;
  std::string filter;
  std::string junit;
  std::string annotate;
  std::string summary;
  bool lists = false;
  bool judges_core_only = false;
  Printing printing;
};

// Differing scenarios of one cause.
struct Group {
  std::string operation;
  std::string detail;
  std::vector<const DescribedRun*> runs = {};
};

struct Report {
  std::vector<std::string> arguments;  // As given.
  std::string golden_option;
  std::vector<DescribedRun> runs = {};
  std::vector<Failure> unlisted = {};  // Folders whose scenarios are not among them.
  std::vector<DescribedCoreVerdict> cores = {};
  std::vector<Group> groups = {};
  std::vector<std::string> never_shown = {};  // Each `sometimes` that no scenario of a whole library shows.
  std::string counts = {};
};

Group cause_of(const Report& report, const DescribedRun& run) {
  const DescribedSummary& summary = run.contents.summary;
  if (summary.early_end && summary.early_end->is_non_finite) return {"non_finite", summary.early_end->what};
  if (!run.comparison->fault.empty()) return {"golden", run.comparison->fault};
  if (run.comparison->has_other_scenario) return {"scenario", run.comparison->shape};
  const std::string folder = golden_folder_of(run.path, report.golden_option);
  const auto core = std::ranges::find(report.cores, folder, &DescribedCoreVerdict::golden_folder);
  if (core != report.cores.end() && !core->changes.empty()) return {"core", core->sentence()};
  if (!run.comparison->shape.empty()) return {"core", run.comparison->shape};
  return {"unknown", core == report.cores.end() || core->status == "none"
                         ? "no accepted core to compare with"
                         : "the core's files are the accepted ones"};
}

// Those of the group that have this golden folder.
std::vector<const DescribedRun*> runs_of(const Report& report, const Group& group,
                                         const DescribedCoreVerdict& verdict) {
  std::vector<const DescribedRun*> runs;
  for (const DescribedRun* const run : group.runs)
    if (golden_folder_of(run->path, report.golden_option) == verdict.golden_folder) runs.push_back(run);
  return runs;
}

void group_by_cause(const DescribedCore& core, Report& report) {
  for (const DescribedRun& run : report.runs) {
    if (!run.comparison || run.comparison->agrees()) continue;
    Group cause = cause_of(report, run);
    const auto is_same = [&](const Group& group) {
      return group.operation == cause.operation && group.detail == cause.detail;
    };
    auto group = std::ranges::find_if(report.groups, is_same);
    if (group == report.groups.end()) group = report.groups.insert(group, std::move(cause));
    group->runs.push_back(&run);
  }
  for (const Group& group : report.groups)
    for (DescribedCoreVerdict& verdict : report.cores)
      if (group.operation == "core") count_reproduced(core, runs_of(report, group, verdict), verdict);
  std::ranges::stable_sort(report.groups, [](const Group& a, const Group& b) {
    return std::pair(a.operation != "non_finite", b.runs.size()) <
           std::pair(b.operation != "non_finite", a.runs.size());
  });
}

// The widest class of a list of runs that need one to be accepted.
DifferenceClass widest_of(const std::vector<const DescribedRun*>& runs) {
  DifferenceClass widest = DifferenceClass::rounding;
  for (const DescribedRun* const run : runs)
    if (run->comparison && run->comparison->difference && !run->comparison->has_other_scenario)
      widest = std::max(widest, *run->comparison->difference);
  return widest;
}

std::string accept_command(const Report& report, const std::vector<const DescribedRun*>& runs) {
  std::vector<std::string> paths = report.arguments;
  if (paths.empty()) paths = {"scenarios"};
  if (runs.size() == 1) paths = {runs.front()->path};
  std::string command = bless_command_for(paths, report.golden_option);
  const DifferenceClass widest = widest_of(runs);
  if (widest > DifferenceClass::rounding) command += fmt::format(" --accept {}", name_of(widest));
  const bool breaks_expect =
      std::ranges::any_of(runs, [](const DescribedRun* run) { return !run->broken().empty(); });
  return command + (breaks_expect ? " --update-expect" : "");
}

void note_never_shown(const DescribedCore& core, Report& report) {
  const auto& properties = core.description.properties;
  for (std::size_t index = 0; index < properties.size(); ++index) {
    const auto shows = [&](const DescribedRun& run) {
      const auto& outcomes = run.contents.summary.properties;
      return index < outcomes.size() && outcomes[index].holds;
    };
    if (!properties[index].is_always && std::ranges::none_of(report.runs, shows))
      report.never_shown.push_back(properties[index].name);
  }
}

bool is_played_whole(const CheckRequest& request) {
  return request.filter.empty() && std::ranges::any_of(request.files, [](const std::string& argument) {
           std::error_code unknown;
           const std::string folder = scenarios_folder_of(argument + "/x.json");
           return is_folder(argument) &&
                  (folder.empty() || std::filesystem::equivalent(argument, folder, unknown));
         });
}

std::string counts_of(const Report& report) {
  std::vector<CheckStatus> statuses;
  for (const DescribedRun& run : report.runs) statuses.push_back(run.status);
  return counts_sentence(statuses, std::ssize(report.unlisted));
}

std::string line_of(const DescribedRun& run) { return fmt::format(": {}\n", printable(run.sentence())); }

void print_report(const Report& report, const Printing& printing) {
  const auto print_line = [](const DescribedRun& run) {
    print_text("{}: {}{}", printable(run.path),
               VerdictWord{name_of(run.status), run.status == CheckStatus::agreed},
               run.status == CheckStatus::agreed ? "\n" : line_of(run));
  };
  for (const DescribedRun& run : report.runs) {
    if (!printing.is_verbose() && run.status == CheckStatus::agreed) continue;
    print_line(run);
    if (printing.is_quiet() || !run.comparison || run.comparison->agrees()) continue;
    if (printing.is_verbose()) print_text("{}", comparison_text(*run.comparison));
  }
  for (const Group& group : report.groups) {
    if (printing.is_quiet()) break;
    print_text("{}: {} {}\n", group.operation == "unknown" ? "cause unknown" : "cause: " + group.operation,
               group.detail, fmt::format("({} of {} scenarios)", group.runs.size(), report.runs.size()));
    if (group.operation != "non_finite")
      print_text("  to accept it    {}\n", accept_command(report, group.runs));
  }
  std::vector<const DescribedRun*> missing, unexpected;
  for (const DescribedRun& run : report.runs) {
    if (run.status == CheckStatus::missing && run.holds()) missing.push_back(&run);
    if (run.status == CheckStatus::disagreed && run.comparison && run.comparison->agrees() &&
        run.faults.empty() && std::ranges::all_of(run.broken(), is_updatable))
      unexpected.push_back(&run);
  }
  for (const auto& [what, runs] : {std::pair("to create", missing), {"to accept", unexpected}})
    if (!runs.empty() && !printing.is_quiet())
      print_text("  {} {}  {}\n", what, runs.size() == 1 ? "it  " : "them", accept_command(report, runs));
  for (const DescribedCoreVerdict& core : report.cores)
    if (!printing.is_quiet()) print_text("{}", core.text());
  for (const std::string& name : report.never_shown)
    print_text("property \"{}\": no scenario shows it\n", name);
  print_text("{}\n", report.counts);
}

Json result_json(const DescribedRun& run) {
  Json::Object object{{"scenario", run.path}, {"status", name_of(run.status)}};
  const bool is_compared = run.comparison.has_value();
  const GoldenComparison none;
  for (auto& [key, value] : comparison_json(is_compared ? *run.comparison : none))
    object.emplace_back(key, is_compared || key == "max" ? std::move(value) : Json());
  if (const std::string sentence = run.sentence(); !sentence.empty())
    object.emplace_back(run.status == CheckStatus::failed ? "error" : "sentence", sentence);
  return object;
}

Json group_json(const Group& group) {
  Json::Array paths;
  std::optional<double> max_px;
  std::int64_t contacts_moved = 0;
  DifferenceClass widest = DifferenceClass::rounding;
  for (const DescribedRun* const run : group.runs) {
    paths.emplace_back(run->path);
    contacts_moved += run->comparison->contacts.total();
    widest = std::max(widest, *run->comparison->difference);
    if (const auto px = run->comparison->max_px()) max_px = std::max(max_px.value_or(0.0), *px);
  }
  return Json::Object{{"operation", group.operation},  {"detail", group.detail},
                      {"scenarios", std::move(paths)}, {"class", name_of(widest)},
                      {"max_px", or_null(max_px)},     {"contacts_moved", contacts_moved},
                      {"rest_shift_px", Json()}};
}

Json report_json(const Report& report) {
  const auto count = [&](CheckStatus status) {
    return std::ranges::count(report.runs, status, &DescribedRun::status);
  };
  return Json::Object{
      {"checked", std::ssize(report.runs) - count(CheckStatus::unreferenced)},
      {"agreed", count(CheckStatus::agreed)},
      {"disagreed", count(CheckStatus::disagreed)},
      {"missing", count(CheckStatus::missing)},
      {"failed", count(CheckStatus::failed)},
      {"unreferenced", count(CheckStatus::unreferenced)},
      {"results", list_of(report.runs, result_json)},
      {"cores", list_of(report.cores, [](const DescribedCoreVerdict& core) { return core.json(); })},
      {"groups", list_of(report.groups, group_json)},
      {"never_shown", Json::Array(report.never_shown.begin(), report.never_shown.end())}};
}

std::vector<ReportEntry> entries_of(const Report& report) {
  std::vector<ReportEntry> entries;
  for (const DescribedRun& run : report.runs) {
    const bool differs = run.comparison && !run.comparison->agrees();
    entries.push_back({run.path, name_of(run.status), run.exit_code, run.sentence(),
                       differs ? comparison_text(*run.comparison) : "", run.path, run.seconds});
  }
  for (const Failure& failure : report.unlisted)
    entries.push_back({failure.what(), "folder", failure.exit_code(), failure.what()});
  for (const DescribedCoreVerdict& core : report.cores)
    if (core.exit_code != ExitCode::agreed)
      entries.push_back(
          {accepted_core_folder(core.golden_folder), "core", core.exit_code, core.why, core.text()});
  return entries;
}

std::vector<ReportSection> sections_of(const Report& report) {
  std::vector<ReportSection> sections;
  for (const Group& group : report.groups) {
    ReportSection& section = sections.emplace_back();
    section.heading = group.operation + ": " + group.detail;
    for (const DescribedRun* const run : group.runs)
      section.lines += fmt::format("{}: {}\n", run->path, run->sentence());
  }
  for (const DescribedCoreVerdict& core : report.cores)
    if (!core.text().empty()) sections.push_back({"", core.text()});
  return sections;
}

void write_documents(const CheckRequest& request, const Report& report, CommandResults& results) {
  const std::vector<ReportEntry> entries = entries_of(report);
  // GitHub reads both streams; the JSON document has standard output to itself.
  if (const std::string annotations = request.annotate.empty() ? "" : github_annotations(entries);
      !request.printing.is_json)
    print_text("{}", annotations);
  else if (!annotations.empty())
    print_error(annotations.substr(0, annotations.size() - 1));
  if (!request.junit.empty())
    results.attempt_after([&] { write_text_file(request.junit, junit_text(entries)); });
  if (!request.summary.empty())
    results.attempt_after([&] {
      write_text_file(request.summary, markdown_text(entries, sections_of(report), report.counts));
    });
}

std::vector<DescribedRun> unreferenced_runs(const CheckRequest& request) {
  std::vector<DescribedRun> runs;
  for (const UnreferencedGolden& golden : find_unreferenced(request.files, request.golden_folder)) {
    DescribedRun& run = runs.emplace_back(DescribedRun{.path = golden.path});
    run.status = golden.error.empty() ? CheckStatus::unreferenced : CheckStatus::failed;
    run.exit_code = golden.error.empty() ? exit_code_of(run.status) : ExitCode::cannot_access;
    run.error = golden.error.empty() ? kUnreferencedSentence : golden.error;
  }
  return runs;
}

// The core of each golden folder, without the scenarios.
void judge_cores(const DescribedCore& core, Report& report, const std::vector<std::string>& files) {
  std::set<std::string> folders;
  for (const Library& library : libraries_of(files, report.golden_option))
    folders.insert(library.golden_folder);
  for (const std::string& folder : folders)
    if (is_folder(folder))
      report.cores.push_back(verdict_on_core(core, folder, report.arguments, report.golden_option));
}

// The core, each description to the last row, and whether some scenario shows each `sometimes`.
ExitCode check_core(const DescribedCore& core, const CheckRequest& request, Report& report) {
  const std::vector<Library> libraries = libraries_of(request.files, request.golden_folder);
  if (libraries.empty())
    refuse_input("hyrax-sim check: --core: needs a folder named scenarios, or a folder and --golden (found " +
                 request.files.front() + ")");
  CommandResults results;
  judge_cores(core, report, request.files);
  if (report.cores.empty()) results.add(ExitCode::golden_missing);
  for (const DescribedCoreVerdict& verdict : report.cores)
    results.add(verdict.status == "none" && verdict.exit_code == ExitCode::agreed ? ExitCode::golden_missing
                                                                                  : verdict.exit_code);
  Json::Array faults;
  for (const Library& library : libraries)
    for (const std::string& path : list_scenarios({library.scenarios_folder}))
      results.attempt(path, [&] {
        DescribedRun& run = report.runs.emplace_back(DescribedRun{.path = path});
        run.scenario = load_described_scenario(core.description, path);
        run.contents = play_for_golden(core, run.scenario);
        const auto fault =
            description_fault(core, run.scenario, kStepsMax + 1, run.contents.summary.state_hash);
        if (!fault) return;
        results.add(ExitCode::disagreed);
        faults.push_back(Json::Object{{"scenario", path}, {"sentence", *fault}});
        if (!request.printing.is_json) print_text("{}: {}\n", printable(path), printable(*fault));
      });
  note_never_shown(core, report);
  if (!report.never_shown.empty()) results.add(ExitCode::disagreed);
  if (request.printing.is_json) {
    print_json(Json::Object{
        {"cores", list_of(report.cores, [](const DescribedCoreVerdict& verdict) { return verdict.json(); })},
        {"faults", std::move(faults)},
        {"never_shown", Json::Array(report.never_shown.begin(), report.never_shown.end())}});
    return results.exit_code();
  }
  if (report.cores.empty()) print_text("core: no golden folder {}\n", libraries.front().golden_folder);
  for (const DescribedCoreVerdict& verdict : report.cores)
    print_text("{}", verdict.status == "accepted" ? "core: the accepted one\n" : verdict.text());
  for (const std::string& name : report.never_shown)
    print_text("property \"{}\": no scenario shows it\n", name);
  return results.exit_code();
}

ExitCode check(const DescribedCore& core, CheckRequest& request) {
  Report report{.arguments = request.files, .golden_option = request.golden_folder};
  if (request.judges_core_only &&
      (request.lists || !(request.filter + request.junit + request.annotate + request.summary).empty()))
    refuse_input("hyrax-sim check: --core: not with --filter, --list, --junit, --annotate or --summary");
  set_default_folders(request.files, request.golden_folder);
  if (request.judges_core_only) return check_core(core, request, report);
  std::vector<std::string> paths = list_scenarios(request.files, report.unlisted);
  std::vector<DescribedRun> unreferenced = unreferenced_runs(request);
  const auto is_left_out = [&](const std::string& path) {
    return path.find(request.filter) == std::string::npos;
  };
  std::erase_if(paths, is_left_out);
  std::erase_if(unreferenced, [&](const DescribedRun& run) { return is_left_out(run.path); });
  if (paths.empty() && unreferenced.empty()) {
    if (!report.unlisted.empty()) throw report.unlisted.front();
    refuse_input("hyrax-sim check: --filter: no path contains it (found " + request.filter + ")");
  }
  CommandResults results;
  for (const Failure& failure : report.unlisted) {
    print_error(failure.what());
    results.add(failure.exit_code());
  }
  if (request.lists) {
    if (request.printing.is_json)
      print_json(Json::Object{{"scenarios", Json::Array(paths.begin(), paths.end())}});
    for (const std::string& path : paths)
      if (!request.printing.is_json) print_text("{}\n", printable(path));
    return results.exit_code();
  }
  OutputGuard guard(paths, request.golden_folder);
  if (!request.junit.empty()) guard.admit("hyrax-sim check: --junit", request.junit);
  if (!request.summary.empty()) guard.admit("hyrax-sim check: --summary", request.summary);
  for (const std::string& path : paths) report.runs.push_back(judge_file(core, path, request.golden_folder));
  if (is_played_whole(request)) note_never_shown(core, report);
  std::ranges::move(unreferenced, std::back_inserter(report.runs));
  judge_cores(core, report, request.files);
  group_by_cause(core, report);
  report.counts = counts_of(report);
  if (request.printing.is_json)
    print_json(report_json(report));
  else
    print_report(report, request.printing);
  for (const DescribedRun& run : report.runs) results.add(run.exit_code);
  for (const DescribedCoreVerdict& verdict : report.cores) results.add(verdict.exit_code);
  write_documents(request, report, results);
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
  options.text(request.junit, {"--junit", "FILE", "also write the verdicts as JUnit XML"});
  options.choice(request.annotate,
                 {"--annotate", "github", "also print a workflow command for each that does not agree"},
                 {"github"});
  options.text(request.summary, {"--summary", "FILE", "also write the report in Markdown"});
  options.text(request.filter, {"--filter", "TEXT", "only those whose paths contain TEXT"});
  options.flag(request.lists, {"--list", "", "print the paths of the scenarios; play nothing"});
  options.flag(request.judges_core_only,
               {"--core", "",
                "compare this program's core with the accepted one, check its description over every row of "
                "the library, and look for `sometimes` properties that no scenario shows"});
  options.printing(request.printing, "print every scenario, and all that is known of those that differ");
}

}  // namespace

Command described_check_command(const DescribedCore& core) {
  return {.name = "check",
          .summary = "play scenarios and compare them with their golden files",
          .example = "hyrax-sim check\n  hyrax-sim check scenarios/first.json --verbose",
          .is_common = true,
          .declare = with_request<CheckRequest>(
              declare, [&core](CheckRequest& request) { return check(core, request); })};
}

}  // namespace hyrax
