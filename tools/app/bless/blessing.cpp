#include "tools/app/bless/bless_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <filesystem>
#include <functional>
#include <map>

#include <unistd.h>

#include "sim/cause/cause.h"
#include "sim/study/reference_model.h"
#include "tools/app/core/core_requirements.h"
#include "tools/app/expect/judged_run.h"
#include "tools/app/library/expect_update.h"
#include "tools/files/non_finite_text.h"
#include "tools/files/path.h"
#include "tools/files/printable.h"
#include "tools/files/scenario_reader.h"
#include "tools/files/summary_text.h"
#include "tools/files/text_file.h"
#include "tools/store/golden_file.h"
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

void require_expected(const Core& core, const Scenario& scenario, const Blessing& blessing) {
  std::string why = non_finite_text(scenario, blessing.summary.final);
  if (why.empty() && play(core, scenario).state_hash != blessing.summary.state_hash) why = kNotRepeated;
  if (why.empty())
    for (const Expectation& broken :
         broken_expectations(core, scenario, blessing.summary, reference_model(core)))
      why.append(why.empty() ? "its expectations do not hold; " : "; ").append(expectation_text(broken));
  if (!why.empty()) throw Failure(ExitCode::disagreed, blessing.path + ": not blessed: " + why);
}

// A golden file whose rows cannot be compared. Its summary may still say that the run is the accepted one.
void replace_unreadable(const Core& core, const Scenario& scenario, const std::string& why,
                        Blessing& blessing) {
  blessing.status = BlessStatus::changed;
  blessing.unreadable = why;
  blessing.comparison.agrees = false;
  blessing.comparison.difference = DifferenceClass::shape;
  blessing.summary = play(core, scenario);
  const std::string& txt_path = blessing.golden->txt_path;
  const std::string text = is_there(txt_path) ? read_text_file(txt_path) : "";
  if (summary_state_hash(text) != hex(blessing.summary.state_hash))
    blessing.differs_in = DifferenceClass::shape;
}

// A summary of an older layout says something else of the same run.
void renew_older_layout(const Core& core, const Scenario& scenario, Blessing& blessing) {
  std::string renewed = renewed_summary(core, scenario, *blessing.golden);
  if (renewed == read_text_file(blessing.golden->txt_path)) return;
  blessing.status = BlessStatus::changed;
  blessing.keeps_h5 = true;
  blessing.renewed_summary = std::move(renewed);
}

// Plays the scenario, and sets what has to be blessed.
void compare(const Core& core, const Scenario& scenario, Blessing& blessing) {
  const auto& [h5_path, txt_path, is_reserved, folder] = *blessing.golden;
  const bool has_both = has_golden_file(*blessing.golden);
  blessing.golden_read = state_of_files(*blessing.golden);
  if (!is_there(h5_path) && !is_there(txt_path)) {
    blessing.status = BlessStatus::fresh;
    blessing.summary = play(core, scenario);
    return;
  }
  if (!is_there(h5_path)) return replace_unreadable(core, scenario, h5_path + " is missing", blessing);
  if (!has_both) blessing.unreadable = txt_path + " is missing";
  try {
    PairComparison pair = *compare_with_pair(core, scenario, *blessing.golden, true, core);
    blessing.status = pair.is_proved || pair.is_kept ? BlessStatus::unchanged : BlessStatus::changed;
    blessing.keeps_h5 = has_both && blessing.status == BlessStatus::changed &&
                        is_h5_current(core, scenario, *blessing.golden);
    if (pair.is_proved) renew_older_layout(core, scenario, blessing);
    static_cast<PairComparison&>(blessing) = std::move(pair);
    const bool is_of_scenario =
        blessing.runs && plays_the_same(blessing.runs->golden.scenario, blessing.runs->fresh.scenario);
    if (is_of_scenario || !blessing.gives_its_rows) blessing.differs_in = blessing.comparison.difference;
  } catch (const Failure& failure) {
    if (failure.exit_code() != ExitCode::bad_input) throw;
    replace_unreadable(core, scenario, failure.what(), blessing);
  }
}

// The hash is updated where there is one.
void update_expect(const Core& core, bool updates_ranges, Blessing& blessing) {
  const std::optional<Expect>& expect = blessing.scenario.expect;
  if (!expect) return;
  std::string updated = blessing.scenario_read;
  if (expect->state_hash) updated = with_updated_hash(updated, hex(blessing.summary.state_hash));
  blessing.has_new_hash = updated != blessing.scenario_read;
  if (updates_ranges) {
    blessing.updated = broken_expectations(core, blessing.scenario, blessing.summary, reference_model(core));
    std::erase_if(blessing.updated, std::not_fn(is_updatable_range));
    updated = with_updated_ranges(std::move(updated), blessing.updated);
  }
  blessing.scenario = parse_scenario_file(updated, blessing.path);
  if (updated != blessing.scenario_read) blessing.scenario_text = std::move(updated);
}

void plan(const Core& core, Blessing& blessing, const BlessOptions& options, const OutputGuard& guard) {
  const std::string text = read_scenario_text(blessing.path);
  blessing.scenario = parse_scenario_file(text, blessing.path);
  require_measurable(core, blessing.path, blessing.scenario);
  blessing.golden = required_golden_place(blessing.path, options.golden_folder);
  blessing.golden_folder = golden_folder_of(blessing.path, options.golden_folder);
  for (const std::string& path : {blessing.golden->h5_path, blessing.golden->txt_path})
    guard.admit_golden("hyrax-sim bless: --golden", path);
  blessing.scenario_read = text;
  compare(core, blessing.scenario, blessing);
  if (options.updates_hash || options.updates_ranges) update_expect(core, options.updates_ranges, blessing);
  if (blessing.scenario_text) require_writable(blessing.path);
  require_expected(core, blessing.scenario, blessing);
  if (blessing.writes_golden_file())
    for (const std::string& path : {blessing.golden->h5_path, blessing.golden->txt_path})
      require_writable(path);
  if (!blessing.writes() || !blessing.differs_in || *blessing.differs_in <= options.accepted) return;
  blessing.status = BlessStatus::refused;
  blessing.exit_code = ExitCode::disagreed;
}

void write_golden_file(const Core& core, const Blessing& blessing, const std::string& reason) {
  const auto& [h5_path, txt_path, is_reserved, folder] = *blessing.golden;
  if (!blessing.renewed_summary.empty()) return write_text_file(txt_path, blessing.renewed_summary);
  const FreshRun fresh = play_for_golden(core, blessing.scenario, core);
  const std::string core_name = core.record.checksum();
  if (blessing.keeps_h5)
    return write_text_file(txt_path, summary_of(core, fresh, reason, file_checksum(h5_path), core_name));
  std::error_code error;
  fs::create_directories(fs::path(h5_path).parent_path(), error);
  AtomicFile rows(h5_path);
  AtomicFile summary(txt_path);
  write_golden(rows, h5_path, fresh.run);
  summary.write(summary_of(core, fresh, reason, file_checksum(rows.part_path()), core_name));
  // The rows come last: until they are there, `check` compares with the old ones and reports it.
  summary.commit();
  rows.commit();
}

// A failure of one scenario does not end the others.
template <class Step>
void attempt(Blessing& blessing, const Step& step) {
  const auto failure = failure_of(blessing.path, step);
  if (!failure) return;
  blessing.error = failure->what();
  blessing.exit_code = failure->exit_code();
  blessing.status = BlessStatus::failed;
  print_error(blessing.error);
}

// Refuses scenarios that share a golden file: each would overwrite the other's. A scenario that is given
// twice is blessed once.
std::vector<Blessing> without_shared_places(std::vector<Blessing> blessings) {
  std::map<std::string, std::string> owners;
  std::vector<Blessing> kept;
  for (Blessing& blessing : blessings) {
    std::error_code unknown;
    if (!blessing.golden) {
      kept.push_back(std::move(blessing));
      continue;
    }
    const std::string place = fs::weakly_canonical(blessing.golden->h5_path, unknown).string();
    const auto [entry, is_first] = owners.emplace(place, blessing.path);
    const std::string& owner = entry->second;
    if (!is_first && !blessing.has_failed()) {
      if (fs::equivalent(owner, blessing.path, unknown)) continue;
      attempt(blessing, [&] {
        refuse_input(blessing.path + ": has the same golden file as " + owner + " (" +
                     blessing.golden->h5_path + "); bless them with different --golden DIR");
      });
    }
    kept.push_back(std::move(blessing));
  }
  return kept;
}

}  // namespace

std::string_view name_of(BlessStatus status) {
  constexpr std::string_view kNames[] = {"new", "changed", "unchanged", "refused", "failed"};
  return kNames[static_cast<std::size_t>(status)];
}

std::vector<Blessing> plan_blessings(const Core& core, const std::vector<std::string>& paths,
                                     const BlessOptions& options) {
  const OutputGuard guard(paths);
  std::vector<Blessing> blessings;
  for (const std::string& path : paths) {
    Blessing& blessing = blessings.emplace_back();
    blessing.path = path;
    attempt(blessing, [&] { plan(core, blessing, options, guard); });
  }
  return without_shared_places(std::move(blessings));
}

void require_unchanged(const std::vector<Blessing>& blessings) {
  for (const Blessing& blessing : blessings)
    for (const auto& [is_changed, path] :
         {std::pair(read_scenario_text(blessing.path) != blessing.scenario_read, blessing.path),
          {state_of_files(*blessing.golden) != blessing.golden_read, blessing.golden->h5_path}})
      if (is_changed)
        throw Failure(ExitCode::cannot_access,
                      "hyrax-sim bless: nothing written: " + path +
                          ": was changed by another program while it was played; bless again");
}

void write(const Core& core, Blessing& blessing, const BlessOptions& options) {
  assert(blessing.writes());
  attempt(blessing, [&] {
    if (blessing.writes_golden_file()) write_golden_file(core, blessing, options.reason);
    if (blessing.scenario_text) write_text_file(blessing.path, *blessing.scenario_text);
  });
}

}  // namespace hyrax
