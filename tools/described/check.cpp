#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "tools/app/command_line/shell_command.h"
#include "tools/app/expect/judged_run.h"
#include "tools/app/library/check_flow.h"
#include "tools/described/commands.h"
#include "tools/described/core_verdict.h"
#include "tools/described/judged_run.h"
#include "tools/described/run_text.h"
#include "tools/described/scenario_json.h"
#include "tools/files/path.h"
#include "tools/files/printable.h"
#include "tools/files/scenario_list.h"

namespace hyrax {
namespace {

// Differing scenarios of one cause.
struct Group {
  std::string operation;
  std::string detail;
  std::vector<const DescribedRun*> runs = {};
};

struct Report : CheckWords {
  CheckSelection selection;
  std::vector<DescribedRun> runs = {};
  std::vector<DescribedCoreVerdict> cores = {};
  std::vector<Group> groups = {};
  std::vector<std::string> never_shown = {};  // Each `sometimes` that no scenario of a whole library shows.
};

Group cause_of(const Report& report, const DescribedRun& run) {
  const DescribedSummary& summary = run.contents.summary;
  if (summary.early_end && summary.early_end->is_non_finite) return {"non_finite", summary.early_end->what};
  if (!run.comparison->fault.empty()) return {"golden", run.comparison->fault};
  if (run.comparison->has_other_scenario) return {"scenario", run.comparison->shape};
  const std::string folder = golden_folder_of(run.path, report.selection.golden_option);
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
    if (golden_folder_of(run->path, report.selection.golden_option) == verdict.golden_folder)
      runs.push_back(run);
  return runs;
}

void group_by_cause(const DescribedCore& core, Report& report) {
  for (const DescribedRun& run : report.runs) {
    if (!run.differs()) continue;
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
  std::vector<std::string> paths = report.selection.arguments;
  if (paths.empty()) paths = {"scenarios"};
  if (runs.size() == 1) paths = {runs.front()->path};
  std::string command = bless_command_for(paths, report.selection.golden_option);
  const DifferenceClass widest = widest_of(runs);
  if (widest > DifferenceClass::rounding) command += fmt::format(" --accept {}", name_of(widest));
  const bool breaks_expect =
      std::ranges::any_of(runs, [](const DescribedRun* run) { return !run->broken.empty(); });
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

// "  to accept it    COMMAND".
std::string accept_line(const Report& report, const char* what,
                        const std::vector<const DescribedRun*>& runs) {
  return fmt::format("  {}  {}\n", what, accept_command(report, runs));
}

Paragraph line_of(const DescribedRun& run, bool has_details) {
  const std::string sentence = run.sentence();
  return {.subject = printable(run.path) + ": ",
          .verdict = std::string(name_of(run.status)),
          .predicate = sentence.empty() ? "" : ": " + printable(sentence),
          .lines = has_details && run.differs() ? run.differences_text(true) : "",
          .is_good = run.status == CheckStatus::agreed};
}

void add_entries(Report& report) {
  for (const DescribedRun& run : report.runs)
    report.entries.push_back({run.path, name_of(run.status), run.exit_code, run.sentence(),
                              run.differs() ? run.differences_text(false) : "", run.path, run.seconds});
  add_counts(pointers_to(report.runs), report.selection, report);
  for (const DescribedCoreVerdict& core : report.cores)
    if (core.exit_code != ExitCode::agreed)
      report.entries.push_back(
          {accepted_core_folder(core.golden_folder), "core", core.exit_code, core.why, core.text()});
}

void put_into_words(Report& report, bool is_verbose) {
  add_entries(report);
  for (const DescribedRun& run : report.runs)
    if (is_verbose || run.status != CheckStatus::agreed)
      report.paragraphs.push_back(line_of(run, is_verbose));
  for (const Group& group : report.groups)
    report.paragraphs.push_back(
        {.subject = fmt::format("{}: {} ({} of {} scenarios)",
                                group.operation == "unknown" ? "cause unknown" : "cause: " + group.operation,
                                group.detail, group.runs.size(), report.runs.size()),
         .lines = group.operation == "non_finite" ? "" : accept_line(report, "to accept it  ", group.runs)});
  std::vector<const DescribedRun*> missing, unexpected;
  for (const DescribedRun& run : report.runs) {
    if (run.status == CheckStatus::missing && run.holds()) missing.push_back(&run);
    if (run.status == CheckStatus::disagreed && run.comparison && !run.differs() && run.faults.empty() &&
        std::ranges::all_of(run.broken, is_updatable))
      unexpected.push_back(&run);
  }
  for (const auto& [what, runs] : {std::pair("to create", missing), {"to accept", unexpected}})
    if (!runs.empty())
      report.paragraphs.push_back(
          {.lines = accept_line(
               report, fmt::format("{} {}", what, runs.size() == 1 ? "it  " : "them").c_str(), runs)});
  for (const DescribedCoreVerdict& core : report.cores) report.paragraphs.push_back({.lines = core.text()});
  for (const std::string& name : report.never_shown)
    report.paragraphs.push_back({.subject = fmt::format("property \"{}\": no scenario shows it", name)});
}

Json result_json(const DescribedRun& run) {
  Json::Object object = result_of(run, name_of(run.status), run.comparison.has_value());
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
  Json::Object document = counts_json(pointers_to(report.runs));
  document.emplace_back("results", list_of(report.runs, result_json));
  document.emplace_back("cores",
                        list_of(report.cores, [](const DescribedCoreVerdict& core) { return core.json(); }));
  document.emplace_back("groups", list_of(report.groups, group_json));
  document.emplace_back("never_shown", Json::Array(report.never_shown.begin(), report.never_shown.end()));
  return document;
}

// The core of each golden folder, without the scenarios.
void judge_cores(const DescribedCore& core, Report& report, const std::vector<std::string>& files) {
  std::set<std::string> folders;
  for (const Library& library : libraries_of(files, report.selection.golden_option))
    folders.insert(library.golden_folder);
  for (const std::string& folder : folders)
    if (is_folder(folder))
      report.cores.push_back(
          verdict_on_core(core, folder, report.selection.arguments, report.selection.golden_option));
}

// The core, each description to the last row, and whether some scenario shows each `sometimes`.
ExitCode check_core(const DescribedCore& core, const CheckRequest& request, Report& report) {
  const std::vector<Library> libraries = required_libraries(request);
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
        DescribedRun& run = report.runs.emplace_back();
        run.path = path;
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
  LastFailed last_failed;
  Report report{{}, select(request, last_failed)};
  const CheckSelection& selection = report.selection;
  if (request.judges_core_only) return check_core(core, request, report);
  if (request.lists) return list(selection, request);
  OutputGuard guard = guard_outputs(selection, request);
  report.runs.resize(selection.paths.size());
  check_all(
      selection.paths.size(), request.jobs,
      [&](std::size_t index, bool reads_golden) {
        report.runs[index] =
            judge_file(core, selection.paths[index],
                       {.golden_folder = request.golden_folder, .reads_golden = reads_golden});
        return !report.runs[index].is_undecided;
      },
      [] {});
  if (!whole_libraries(request, selection.has_failed_only).empty()) note_never_shown(core, report);
  for (const UnreferencedGolden& golden : selection.unreferenced)
    judge_unreferenced(report.runs.emplace_back(), golden);
  last_failed.update(pointers_to(report.runs), guard);
  judge_cores(core, report, request.files);
  group_by_cause(core, report);
  put_into_words(report, request.printing.is_verbose());
  return report_check(request, selection, report, request.printing.is_json ? report_json(report) : Json())
      .exit_code();
}

void declare(Options& options, CheckRequest& request) {
  declare_check(options, request, "",
                "compare this program's core with the accepted one, check its description over every row of "
                "the library, and look for `sometimes` properties that no scenario shows");
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
