#include "tools/app/library/blessing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <filesystem>
#include <functional>
#include <map>
#include <set>

#include "sim/trajectory/physics_model.h"
#include "tools/app/expect/judged_run.h"
#include "tools/app/library/bless_text.h"
#include "tools/files/printable.h"
#include "tools/files/scenario_list.h"
#include "tools/files/scenario_reader.h"
#include "tools/files/summary_text.h"
#include "tools/files/text_file.h"
#include "tools/platform/path.h"
#include "tools/store/golden_summary.h"
#include "tools/store/output_guard.h"

namespace hyrax {
namespace {

namespace fs = std::filesystem;
using BlessStatus = Blessing::Status;

// The checksums of the golden pair's files.
std::string state_of_files(const GoldenPlace& place) {
  std::string state;
  for (const std::string& path : {place.h5_path, place.txt_path})
    state += is_there(path) ? file_checksum(path) : "none";
  return state;
}

// A golden file whose rows cannot be compared. Its summary may still say that the run is the accepted one.
void replace_unreadable(const Blesser& blesser, const std::string& why, Blessing& blessing) {
  blessing.status = BlessStatus::changed;
  blessing.unreadable = why;
  blesser.compare_none(blessing);
  const std::string& txt_path = blessing.verdict->golden->txt_path;
  const std::string text = is_there(txt_path) ? read_text_file(txt_path) : "";
  if (summary_state_hash(text) != blessing.verdict->state_hash) blessing.differs_in = DifferenceClass::shape;
}

void compare(const Blesser& blesser, Blessing& blessing) {
  const auto& [h5_path, txt_path, is_reserved, folder] = *blessing.verdict->golden;
  const bool has_both = has_golden_file(*blessing.verdict->golden);
  blessing.golden_read = state_of_files(*blessing.verdict->golden);
  if (!is_there(h5_path) && !is_there(txt_path)) {
    blessing.status = BlessStatus::fresh;
    return blesser.compare_none(blessing);
  }
  if (!is_there(h5_path)) return replace_unreadable(blesser, h5_path + " is missing", blessing);
  if (!has_both) blessing.unreadable = txt_path + " is missing";
  try {
    blesser.compare(blessing);
  } catch (const Failure& failure) {
    if (failure.exit_code() != ExitCode::bad_input) throw;
    replace_unreadable(blesser, failure.what(), blessing);
  }
}

// The hash is updated where there is one.
void update_expect(const Blesser& blesser, bool updates_ranges, Blessing& blessing) {
  ScenarioVerdict& verdict = *blessing.verdict;
  std::string updated = blessing.scenario_read;
  if (verdict.expects_hash) updated = with_updated_hash(updated, verdict.state_hash);
  blessing.has_new_hash = updated != blessing.scenario_read;
  if (updates_ranges) {
    blessing.updated = verdict.broken;
    std::erase_if(blessing.updated, std::not_fn(is_updatable_range));
    updated = with_updated_ranges(std::move(updated), blessing.updated);
  }
  if (updated == blessing.scenario_read) return;
  blesser.parse(verdict, updated);
  blesser.judge(verdict);
  require_writable(verdict.path);
  blessing.scenario_text = std::move(updated);
}

void require_expected(const ScenarioVerdict& verdict) {
  std::string why;
  for (const std::string& fault : verdict.faults) why.append(why.empty() ? "" : "; ").append(fault);
  if (why.empty())
    for (const Expectation& broken : verdict.broken)
      why.append(why.empty() ? "its expectations do not hold; " : "; ").append(expectation_text(broken));
  if (!why.empty()) throw Failure(ExitCode::disagreed, verdict.path + ": not blessed: " + why);
}

void plan(const Blesser& blesser, Blessing& blessing, const BlessRequest& request, const OutputGuard& guard) {
  ScenarioVerdict& verdict = *blessing.verdict;
  blessing.scenario_read = read_scenario_text(verdict.path);
  blesser.parse(verdict, blessing.scenario_read);
  verdict.golden = required_golden_place(verdict.path, request.golden_folder);
  verdict.golden_folder = golden_folder_of(verdict.path, request.golden_folder);
  for (const std::string& path : {verdict.golden->h5_path, verdict.golden->txt_path})
    guard.admit_golden("hyrax-sim bless: --golden", path);
  compare(blesser, blessing);
  blesser.judge(verdict);
  if (request.updates_hash || request.updates_ranges)
    update_expect(blesser, request.updates_ranges, blessing);
  require_expected(verdict);
  if (blessing.writes_golden_file())
    for (const std::string& path : {verdict.golden->h5_path, verdict.golden->txt_path})
      require_writable(path);
  if (!blessing.writes() || !blessing.differs_in || request.accepts(*blessing.differs_in)) return;
  blessing.status = BlessStatus::refused;
  verdict.exit_code = ExitCode::disagreed;
}

// A failure of one scenario does not end the others.
void attempt(Blessing& blessing, const std::function<void()>& step) {
  ScenarioVerdict& verdict = *blessing.verdict;
  const auto failure = failure_of(verdict.path, step);
  if (!failure) return;
  verdict.error = failure->what();
  verdict.exit_code = failure->exit_code();
  blessing.status = BlessStatus::failed;
  print_error(verdict.error);
}

// Refuses scenarios that share a golden file: each would overwrite the other's. A scenario that is given
// twice is blessed once.
std::vector<Blessing> without_shared_places(std::vector<Blessing> blessings) {
  std::map<std::string, std::string> owners;
  std::vector<Blessing> kept;
  for (Blessing& blessing : blessings) {
    const ScenarioVerdict& verdict = *blessing.verdict;
    std::error_code unknown;
    if (!verdict.golden) {
      kept.push_back(std::move(blessing));
      continue;
    }
    const std::string place = fs::weakly_canonical(verdict.golden->h5_path, unknown).string();
    const auto [entry, is_first] = owners.emplace(place, verdict.path);
    const std::string& owner = entry->second;
    if (!is_first && !blessing.has_failed()) {
      if (fs::equivalent(owner, verdict.path, unknown)) continue;
      attempt(blessing, [&] {
        refuse_input(verdict.path + ": has the same golden file as " + owner + " (" +
                     verdict.golden->h5_path + "); bless them with different --golden DIR");
      });
    }
    kept.push_back(std::move(blessing));
  }
  return kept;
}

// Throws where a file of a blessing is not as it was read.
void require_unchanged(const std::vector<Blessing>& blessings) {
  for (const Blessing& blessing : blessings) {
    const ScenarioVerdict& verdict = *blessing.verdict;
    for (const auto& [is_changed, path] :
         {std::pair(read_scenario_text(verdict.path) != blessing.scenario_read, verdict.path),
          {state_of_files(*verdict.golden) != blessing.golden_read, verdict.golden->h5_path}})
      if (is_changed)
        throw Failure(ExitCode::cannot_access,
                      "hyrax-sim bless: nothing written: " + path +
                          ": was changed by another program while it was played; bless again");
  }
}

std::string canonical_path(const std::string& path) {
  std::error_code unknown;
  return fs::weakly_canonical(path, unknown).string();
}

// Those that are blessed now, by their canonical paths.
using BlessingsByPath = std::map<std::string, const Blessing*>;

// What became of the scenarios that are not blessed now.
struct LibraryCheck {
  std::vector<std::string> disagreeing;
  std::string not_repeated;     // A sentence on one that agrees, but is no result to bless.
  std::set<std::string> cores;  // That golden files name which stay as they are.
  std::size_t checked = 0;
};

LibraryCheck check_library(const Blesser& blesser, const Library& library, const std::string& golden_option,
                           const BlessingsByPath& blessed) {
  LibraryCheck result;
  for (const std::string& path : list_scenarios({library.scenarios_folder})) {
    ++result.checked;
    if (const auto found = blessed.find(canonical_path(path)); found != blessed.end()) {
      const Blessing& blessing = *found->second;
      if (blessing.status == BlessStatus::unchanged)
        result.cores.insert(summary_core(read_text_file(blessing.verdict->golden->txt_path)));
      continue;
    }
    const std::shared_ptr<ScenarioVerdict> verdict = blesser.check(path, golden_option);
    if (verdict->status != CheckStatus::agreed)
      result.disagreeing.push_back(path);
    else if (!verdict->faults.empty())
      result.not_repeated = path + ": " + verdict->faults.front();
    else if (has_golden_file(*verdict->golden))
      result.cores.insert(summary_core(read_text_file(verdict->golden->txt_path)));
  }
  return result;
}

std::optional<CoreAcceptance> plan_core(const Blesser& blesser, const Library& library,
                                        const BlessingsByPath& blessed, const BlessRequest& request) {
  CoreAcceptance acceptance{.golden_folder = library.golden_folder, .core = blesser.program_core()};
  AcceptedCore& accepted = acceptance.core;
  const std::optional<AcceptedCore> before = undamaged_core(library.golden_folder);
  if (before && before->header == accepted.header && before->files == accepted.files &&
      before->step == accepted.step && before->description == accepted.description &&
      before->model == accepted.model)
    return std::nullopt;
  LibraryCheck check = check_library(blesser, library, request.golden_folder, blessed);
  accepted.reason = request.reason;
  check.cores.erase(accepted.name());
  check.cores.erase("");
  accepted.agreeing_cores.assign(check.cores.begin(), check.cores.end());
  if (!check.disagreeing.empty()) {
    acceptance.why_not = fmt::format("{} of {} scenarios do not agree, the first is {}",
                                     check.disagreeing.size(), check.checked, check.disagreeing.front());
  } else if (!check.not_repeated.empty()) {
    acceptance.why_not = check.not_repeated;
  } else if (before && !is_same_model(before->model, accepted.model) &&
             !request.accepts(DifferenceClass::shape)) {
    acceptance.is_refused = true;
    acceptance.why_not = fmt::format(
        "the accepted core is of another class (found {}); --accept shape replaces it", before->model);
  } else {
    const std::string& header = accepted.header_name;
    for (const std::string& name : {header.empty() ? "physics.h" : header, std::string("step.txt"),
                                    std::string("accepted.txt"), std::string("files/of_project")})
      require_writable(accepted_core_folder(library.golden_folder) + "/" + name);
    acceptance.unnoticed = blesser.unnoticed(library);
  }
  return acceptance;
}

// Of libraries_of(arguments). Plays each whole, unless its accepted core is this program's already: then
// nothing is planned.
std::vector<CoreAcceptance> plan_cores(const Blesser& blesser, const std::vector<std::string>& arguments,
                                       const std::vector<Blessing>& blessings, const BlessRequest& request) {
  BlessingsByPath blessed;
  for (const Blessing& blessing : blessings)
    blessed.emplace(canonical_path(blessing.verdict->path), &blessing);
  std::vector<CoreAcceptance> acceptances;
  for (const Library& library : libraries_of(arguments, request.golden_folder))
    if (auto acceptance = plan_core(blesser, library, blessed, request))
      acceptances.push_back(std::move(*acceptance));
  return acceptances;
}

// If a blessing has failed, none is.
void write_cores(std::vector<CoreAcceptance>& cores, bool has_failed) {
  for (CoreAcceptance& acceptance : cores) {
    if (!acceptance.why_not.empty()) continue;
    if (has_failed)
      acceptance.why_not = "not every golden file could be written";
    else
      write_accepted_core(acceptance.golden_folder, acceptance.core);
  }
}

void complete(BlessRequest& request) {
  if (request.prunes && request.files.empty()) request.files = {"scenarios"};
  if (request.accepts_core_only) set_default_folder(request.files);
  if (request.files.empty())
    refuse_input("hyrax-sim bless: SCENARIO: at least 1 needed (found 0); see `hyrax-sim bless --help`");
  if (request.blesses() && request.reason.find_first_not_of(" \t\n") == std::string::npos)
    refuse_input(
        "hyrax-sim bless: --reason must say why the golden files change, as in --reason 'wider window'");
  request.reason = printable_lines(request.reason);
  std::ranges::replace(request.reason, '\n', ' ');
}

void write(const Blesser& blesser, const std::string& reason, BlessReport& report) {
  require_unchanged(report.blessings);
  for (Blessing& blessing : report.blessings)
    if (blessing.writes()) write(blesser, blessing, reason);
  const std::string unfinished = unfinished_sentence(report);
  if (!unfinished.empty()) {
    print_error(unfinished);
    report.pruning.removed.clear();
  }
  remove_files(report.pruning.removed);
  write_cores(report.cores, !unfinished.empty());
  for (const std::string& sentence : git_ignored_sentences(report)) print_error(sentence);
}

}  // namespace

bool BlessRequest::accepts(DifferenceClass difference) const {
  const auto widest = std::ranges::find(kDifferenceClasses, accepted,
                                        [](DifferenceClass value) { return hyrax::name_of(value); });
  return difference <= *widest;
}

std::vector<Blessing> plan_blessings(const Blesser& blesser, const std::vector<std::string>& paths,
                                     const BlessRequest& request) {
  const OutputGuard guard(paths);
  std::vector<Blessing> blessings;
  for (const std::string& path : paths) {
    Blessing& blessing = blessings.emplace_back();
    blessing.verdict = blesser.verdict();
    blessing.verdict->path = path;
    attempt(blessing, [&] { plan(blesser, blessing, request, guard); });
  }
  return without_shared_places(std::move(blessings));
}

void write(const Blesser& blesser, Blessing& blessing, const std::string& reason) {
  assert(blessing.writes());
  attempt(blessing, [&] {
    const GoldenPlace& place = *blessing.verdict->golden;
    std::error_code error;
    fs::create_directories(fs::path(place.h5_path).parent_path(), error);
    if (!blessing.renewed_summary.empty())
      write_text_file(place.txt_path, blessing.renewed_summary);
    else if (blessing.writes_golden_file())
      blesser.write_pair(blessing, reason);
    if (blessing.scenario_text) write_text_file(blessing.verdict->path, *blessing.scenario_text);
  });
}

ExitCode bless(const Blesser& blesser, BlessRequest& request) {
  complete(request);
  BlessReport report;
  if (request.prunes)
    report.pruning = find_prunable(request.files, request.golden_folder,
                                   [&](const std::string& path) { return blesser.is_golden_h5(path); });
  const std::vector<std::string> paths =
      request.blesses() ? list_scenarios(request.files) : std::vector<std::string>{};
  if (!request.accepts_core_only) report.blessings = plan_blessings(blesser, paths, request);
  if (refusal_sentence(report).empty())
    report.cores = plan_cores(blesser, request.blesses() ? request.files : paths, report.blessings, request);
  const bool is_refused = !refusal_sentence(report).empty();
  BlessWords words;
  if (!request.printing.is_quiet() || request.printing.is_json) words = blesser.words(report, request);
  if (!request.printing.is_json) print_plans(report, words, request.printing);
  if (is_refused) print_error(refusal_sentence(report));
  report.is_written = !is_refused && !request.is_dry_run;
  if (report.is_written) write(blesser, request.reason, report);
  if (request.accepts_core_only && report.cores.empty()) {
    if (libraries_of(request.files, request.golden_folder).empty())
      refuse_input(
          "hyrax-sim bless: --core: needs scenarios below a folder named scenarios, or a folder "
          "and --golden (found " +
          request.files.front() + ")");
    if (!request.printing.is_json) print_text("core: accepted already\n");
  }
  if (request.printing.is_json) {
    if (request.accepts_core_only)
      report.is_written &= std::ranges::any_of(report.cores, &std::string::empty, &CoreAcceptance::why_not);
    print_json(bless_json(report, std::move(words.groups)));
  } else {
    print_done(report, request.is_dry_run);
  }
  for (const std::string& path : report.pruning.left)
    print_error(path + ": has no scenario; left, as `bless` did not write it");
  if (request.prunes && report.pruning.removed.empty() && report.pruning.left.empty() &&
      !request.printing.is_json)
    print_text("no golden file without a scenario\n");
  ExitCode exit_code = ExitCode::agreed;
  for (const Blessing& blessing : report.blessings)
    exit_code = more_serious(exit_code, blessing.verdict->exit_code);
  for (const CoreAcceptance& acceptance : report.cores)
    if (acceptance.is_refused || (request.accepts_core_only && !acceptance.why_not.empty()))
      exit_code = more_serious(exit_code, ExitCode::disagreed);
  return exit_code;
}

void declare_bless(Options& options, BlessRequest& request, const std::string& fixed,
                   const std::string& verbose_help) {
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
  options.flag(request.is_dry_run, {"--dry-run", "", "show what would change; write nothing"});
  options.flag(request.updates_hash, {"--update-hash", "",
                                      "put the new `expect.state_hash` into the scenario files that have "
                                      "one; nothing else in them changes"});
  options.flag(request.updates_ranges,
               {"--update-expect", "",
                "as --update-hash, and new values for counts and ranges of `expect` that do not hold: a "
                "range keeps its width. Booleans, " +
                    fixed + " and one-sided limits never change"});
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
  options.printing(request.printing, verbose_help);
}

}  // namespace hyrax
