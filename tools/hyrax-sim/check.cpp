#include <algorithm>
#include <filesystem>

#include "tools/app/check/check_verdict.h"
#include "tools/files/scenario_writer.h"
#include "tools/files/text_file.h"
#include "tools/platform/path.h"
#include "tools/store/golden_file.h"

namespace hyrax {
namespace {

constexpr std::int64_t kFlings = 1000;

// Those that are open have a golden file. A library that is red all over costs one child process, not one
// each.
void read_open_goldens(const std::vector<CheckVerdict>& verdicts) {
  std::vector<std::string> paths;
  for (const CheckVerdict& verdict : verdicts)
    if (verdict.is_undecided && verdict.golden && has_golden_file(*verdict.golden))
      paths.push_back(verdict.golden->h5_path);
  read_goldens_ahead(paths);
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
  const std::vector<Library> libraries = required_libraries(request);
  cores.judge_differences(libraries, request.flings.value_or(kFlings));
  Json::Array documents;
  CommandResults results;
  for (const CoreVerdict* const verdict : cores.verdicts()) {
    documents.push_back(core_json(*verdict));
    results.add(verdict->exit_code_alone());
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

std::vector<CoreWords> words_of(const CoreChecks& cores, bool scenarios_agree) {
  std::vector<CoreWords> words;
  const std::vector<const CoreVerdict*> verdicts = cores.verdicts();
  for (const CoreVerdict* const core : verdicts) {
    words.push_back(
        {core->golden_folder, core->exit_code, core_text(*core, verdicts.size() == 1, scenarios_agree)});
    words.back().mark_first_of(core->changes);
  }
  return words;
}

ExitCode check(const Core& core, CheckRequest& request) {
  LastFailed last_failed;
  CheckSelection selection = select(request, last_failed);
  if (request.judges_core_only)
    return check_core(request, CoreChecks(core, selection.arguments, selection.golden_option));
  if (request.lists) return list(selection, request);
  OutputGuard guard = guard_outputs(selection, request);
  CheckOptions options{.golden_folder = request.golden_folder,
                       .watched_step = request.printing.is_json ? program_step(core) : nullptr,
                       .draws = !request.page.empty()};
  std::vector<CheckVerdict> verdicts(selection.paths.size());
  check_all(
      verdicts.size(), request.jobs,
      [&](std::size_t index, bool reads_golden) {
        CheckOptions of_one = options;
        of_one.reads_golden = reads_golden;
        verdicts[index] = check_scenario(core, selection.paths[index], of_one);
        return !verdicts[index].is_undecided;
      },
      [&] { read_open_goldens(verdicts); });
  for (const UnreferencedGolden& golden : selection.unreferenced)
    verdicts.push_back(unreferenced_verdict(golden));
  CheckReport report(std::move(selection), verdicts);
  last_failed.update(report.verdicts, guard);
  CoreChecks cores(core, report.selection.arguments, report.selection.golden_option);
  std::vector<const PairVerdict*> differing;
  for (const CheckVerdict& verdict : verdicts) {
    if (is_folder(verdict.golden_folder)) cores.of(verdict.golden_folder).take_paths(verdict.paths_taken);
    if (verdict.status == CheckStatus::disagreed && verdict.differs()) differing.push_back(&verdict);
  }
  set_groups(differing.empty() ? std::vector<DifferenceGroup>() : group_by_cause(differing, cores), report);
  std::vector<Library> libraries = whole_libraries(request, report.selection.has_failed_only);
  std::erase_if(libraries, [](const Library& library) { return !is_folder(library.golden_folder); });
  cores.judge_differences(libraries, request.flings.value_or(kFlings));
  put_into_words(words_of(cores, report.groups.empty()), report);
  CommandResults results =
      report_check(request, report, request.printing.is_json ? check_json(report, cores) : Json(),
                   request.page.empty() ? std::vector<Figure>() : check_figures(report));
  results.attempt_after([&] { write_unnoticed(cores.verdicts(), request.unnoticed_folder); });
  for (const CheckVerdict& verdict : verdicts)
    if (!verdict.note.empty()) print_error(verdict.note);
  return results.exit_code();
}

void declare(Options& options, CheckRequest& request) {
  declare_check(
      options, request,
      " with a sheet of all runs, and both paths of the worst scenario of each of the first three causes",
      "only compare the core with the accepted one of golden/core, and look for changes that no "
      "scenario notices; exit code 1 if there is one, 4 if no core is accepted");
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
