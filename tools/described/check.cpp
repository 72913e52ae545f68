#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "tools/app/library/check_flow.h"
#include "tools/described/commands.h"
#include "tools/described/core_verdict.h"
#include "tools/described/run_text.h"
#include "tools/described/scenario_json.h"
#include "tools/files/printable.h"
#include "tools/files/scenario_list.h"
#include "tools/platform/path.h"

namespace hyrax {
namespace {

// Of runs, and of cores.
struct Found {
  std::vector<DescribedRun> runs = {};
  std::vector<DescribedCoreVerdict> cores = {};
  std::vector<std::string> never_shown = {};  // Each `sometimes` that no scenario of a whole library shows.
};

Cause cause_of(const std::vector<DescribedCoreVerdict>& cores, const DescribedRun& run) {
  if (run.is_non_finite) return {CauseKind::non_finite, run.contents.summary.early_end->what};
  if (!run.golden_fault.empty()) return {CauseKind::golden, run.golden_fault};
  if (run.comparison->has_other_scenario)
    return {CauseKind::scenario, run.comparison->shape.substr(run.comparison->shape.find(": ") + 2)};
  const auto core = std::ranges::find(cores, run.golden_folder, &DescribedCoreVerdict::golden_folder);
  if (core != cores.end() && core->status == CoreStatus::proved_equal)
    return {CauseKind::unknown, "the core's step is proved equal to the accepted one"};
  if (core != cores.end() && !core->changes.empty()) return {CauseKind::core, core->sentence()};
  if (!run.comparison->shape.empty()) return {CauseKind::core, run.comparison->shape};
  return {CauseKind::unknown, core == cores.end() || core->status == CoreStatus::none
                                  ? "no accepted core to compare with"
                                  : "the core's files are the accepted ones"};
}

// Runs that become non-finite first, then the largest groups.
std::vector<DifferenceGroup> groups_of(const Found& found) {
  std::vector<std::pair<Cause, std::vector<const ScenarioVerdict*>>> runs_of;
  for (const DescribedRun& run : found.runs) {
    if (!run.differs()) continue;
    const Cause cause = cause_of(found.cores, run);
    auto group = std::ranges::find_if(runs_of, [&cause](const auto& each) { return each.first == cause; });
    if (group == runs_of.end()) group = runs_of.insert(group, {cause, {}});
    group->second.push_back(&run);
  }
  std::ranges::stable_sort(runs_of, {}, [](const auto& each) {
    return std::pair(each.first.kind != CauseKind::non_finite, -std::ssize(each.second));
  });
  std::vector<DifferenceGroup> groups;
  for (auto& [cause, runs] : runs_of) groups.push_back(make_group(std::move(cause), std::move(runs)));
  return groups;
}

// Which changed defaults give the golden files of the runs that the core is the cause of.
void count_reproduced(const DescribedCore& core, Found& found) {
  for (DescribedCoreVerdict& verdict : found.cores) {
    std::vector<const DescribedRun*> runs;
    for (const DescribedRun& run : found.runs)
      if (run.differs() && run.golden_folder == verdict.golden_folder &&
          cause_of(found.cores, run).kind == CauseKind::core)
        runs.push_back(&run);
    if (!runs.empty()) count_reproduced(core, runs, verdict);
  }
}

void note_never_shown(const DescribedCore& core, Found& found) {
  const auto& properties = core.description.properties;
  for (std::size_t index = 0; index < properties.size(); ++index) {
    const auto shows = [&](const DescribedRun& run) {
      const auto& outcomes = run.contents.summary.properties;
      return index < outcomes.size() && outcomes[index].holds;
    };
    if (!properties[index].is_always && std::ranges::none_of(found.runs, shows))
      found.never_shown.push_back(properties[index].name);
  }
}

Json result_json(const DescribedRun& run) {
  Json::Object object = result_of(run, name_of(run.status), run.comparison.has_value());
  if (const std::string sentence = run.sentence(); !sentence.empty())
    object.emplace_back(run.status == CheckStatus::failed ? "error" : "sentence", sentence);
  return object;
}

Json report_json(const CheckReport& report, const Found& found) {
  Json::Object document = counts_json(report);
  document.emplace_back("results", list_of(found.runs, result_json));
  document.emplace_back("cores",
                        list_of(found.cores, [](const DescribedCoreVerdict& core) { return core.json(); }));
  document.emplace_back("groups", list_of(report.groups, group_json));
  document.emplace_back("never_shown", Json::Array(found.never_shown.begin(), found.never_shown.end()));
  return document;
}

// The core of each golden folder, without the scenarios.
void judge_cores(const DescribedCore& core, const CheckRequest& request, const CheckSelection& selection,
                 Found& found) {
  std::set<std::string> folders;
  for (const Library& library : libraries_of(request.files, selection.golden_option))
    folders.insert(library.golden_folder);
  for (const std::string& folder : folders)
    if (request.judges_core_only || is_folder(folder))
      found.cores.push_back(verdict_on_core(core, folder, selection.arguments, selection.golden_option));
}

// The core, each description to the last row, and whether some scenario shows each `sometimes`.
ExitCode check_core(const DescribedCore& core, const CheckRequest& request, const CheckSelection& selection) {
  Found found;
  const std::vector<Library> libraries = required_libraries(request);
  CommandResults results;
  judge_cores(core, request, selection, found);
  for (const DescribedCoreVerdict& verdict : found.cores) results.add(verdict.exit_code_alone());
  Json::Array faults;
  bool agree = true;
  for (const Library& library : libraries)
    for (const std::string& path : list_scenarios({library.scenarios_folder}))
      results.attempt(path, [&] {
        const bool others_agree = std::exchange(agree, false);  // Of one that cannot be read it stays.
        DescribedRun& run = found.runs.emplace_back();
        run.path = path;
        run.scenario = load_described_scenario(core.description, path);
        run.contents = play_for_golden(core, run.scenario);
        const auto place = golden_place(path, request.golden_folder);
        run.judge(core.description);
        agree = others_agree && run.broken.empty() &&
                faults_of_run(core.description, run.contents.summary).empty() && place &&
                has_golden_file(*place) && is_proved_to_agree(core, run.scenario, run.contents, *place);
        const auto fault = description_fault(core, run.scenario, kStepsMax + 1, &run.contents.summary);
        if (!fault) return;
        results.add(ExitCode::disagreed);
        faults.push_back(Json::Object{{"scenario", path}, {"sentence", *fault}});
        if (!request.printing.is_json) print_text("{}: {}\n", printable(path), printable(*fault));
      });
  note_never_shown(core, found);
  if (!found.never_shown.empty()) results.add(ExitCode::disagreed);
  if (request.printing.is_json) {
    print_json(Json::Object{
        {"cores", list_of(found.cores, [](const DescribedCoreVerdict& verdict) { return verdict.json(); })},
        {"faults", std::move(faults)},
        {"never_shown", Json::Array(found.never_shown.begin(), found.never_shown.end())}});
    return results.exit_code();
  }
  for (const DescribedCoreVerdict& verdict : found.cores)
    print_text("{}", verdict.status == CoreStatus::accepted ? "core: the accepted one\n"
                                                            : verdict.text(agree && faults.empty()));
  for (const std::string& name : found.never_shown)
    print_text("property \"{}\": no scenario shows it\n", name);
  return results.exit_code();
}

ExitCode check(const DescribedCore& core, CheckRequest& request) {
  LastFailed last_failed;
  CheckSelection selection = select(request, last_failed);
  if (request.judges_core_only) return check_core(core, request, selection);
  if (request.lists) return list(selection, request);
  OutputGuard guard = guard_outputs(selection, request);
  Found found;
  found.runs.resize(selection.paths.size());
  check_all(
      selection.paths.size(), request.jobs,
      [&](std::size_t index, bool reads_golden) {
        found.runs[index] = judge_file(core, selection.paths[index],
                                       {.golden_folder = request.golden_folder,
                                        .reads_golden = reads_golden,
                                        .draws = !request.page.empty()});
        return !found.runs[index].is_undecided;
      },
      [] {});
  if (!whole_libraries(request, selection.has_failed_only).empty()) note_never_shown(core, found);
  for (const UnreferencedGolden& golden : selection.unreferenced)
    judge_unreferenced(found.runs.emplace_back(), golden);
  CheckReport report(std::move(selection), found.runs);
  last_failed.update(report.verdicts, guard);
  judge_cores(core, request, report.selection, found);
  count_reproduced(core, found);
  set_groups(groups_of(found), report);
  std::vector<CoreWords> cores;
  for (const DescribedCoreVerdict& verdict : found.cores) {
    cores.push_back({verdict.golden_folder, verdict.exit_code, verdict.text(report.groups.empty())});
    cores.back().mark_first_of(verdict.changes);
  }
  put_into_words(cores, report);
  for (const std::string& name : found.never_shown)
    report.paragraphs.push_back({.subject = fmt::format("property \"{}\": no scenario shows it", name)});
  return report_check(request, report, request.printing.is_json ? report_json(report, found) : Json())
      .exit_code();
}

void declare(Options& options, CheckRequest& request) {
  declare_check(options, request, " with a sheet of all runs",
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
