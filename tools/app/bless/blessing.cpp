#include "tools/app/bless/bless_report.h"

#include <cassert>
#include <cerrno>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>

#include <unistd.h>

#include "sim/study/reference_model.h"
#include "tools/app/core/paper_model.h"
#include "tools/app/expect/judged_run.h"
#include "tools/files/json_edit.h"
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

GoldenPlace place_of(const std::string& path, const std::string& golden_folder) {
  if (path == "-") refuse_input("-: standard input has no golden file; name a scenario file");
  const auto place = golden_place(path, golden_folder);
  if (!place)
    refuse_input(path +
                 ": no folder `scenarios` above it; name the folder of its golden file with --golden DIR");
  return *place;
}

// As far as possible without writing.
void require_writable(const std::string& path) {
  fs::path folder = fs::absolute(path).parent_path();
  while (!is_there(folder.string()) && folder.has_relative_path()) folder = folder.parent_path();
  if (!is_folder(folder.string())) fail_to_write(path, ENOTDIR);
  if (access(folder.c_str(), W_OK | X_OK) != 0) fail_to_write(path, errno);
}

void require_usable(const GoldenPlace& place, const OutputGuard& guard) {
  for (const std::string& path : {place.h5_path, place.txt_path}) {
    if (is_folder(path)) fail_to_write(path, EISDIR);
    guard.admit_golden("hyrax-sim bless: --golden", path);
  }
}

void require_expected(const Core& core, const Scenario& scenario, const Blessing& blessing) {
  std::string why = non_finite_text(scenario, blessing.summary.final);
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

// Plays the scenario, and sets what has to be blessed.
void compare(const Core& core, const Scenario& scenario, Blessing& blessing) {
  const auto& [h5_path, txt_path, is_reserved, folder] = *blessing.golden;
  const bool has_both = has_golden_file(*blessing.golden);
  if (!is_there(h5_path) && !is_there(txt_path)) {
    blessing.status = BlessStatus::fresh;
    blessing.summary = play(core, scenario);
    return;
  }
  if (!is_there(h5_path)) return replace_unreadable(core, scenario, h5_path + " is missing", blessing);
  if (!has_both) blessing.unreadable = txt_path + " is missing";
  try {
    PairComparison pair = *compare_with_pair(core, scenario, *blessing.golden, true, core);
    blessing.status = pair.is_proved ? BlessStatus::unchanged : BlessStatus::changed;
    blessing.keeps_h5 = has_both && !pair.is_proved && is_h5_current(core, scenario, *blessing.golden);
    static_cast<PairComparison&>(blessing) = std::move(pair);
    const bool is_of_scenario =
        blessing.runs && plays_the_same(blessing.runs->golden.scenario, blessing.runs->fresh.scenario);
    if (is_of_scenario || !blessing.gives_its_rows) blessing.differs_in = blessing.comparison.difference;
  } catch (const Failure& failure) {
    if (failure.exit_code() != ExitCode::bad_input) throw;
    replace_unreadable(core, scenario, failure.what(), blessing);
  }
}

std::vector<std::string> ends_around(double middle, const Interval& interval, bool is_whole) {
  const double width = interval.high - interval.low;
  if (!is_whole) return {to_text(middle - width / 2.0), to_text(middle + width / 2.0)};
  const double low = std::max(0.0, middle - std::floor(width / 2.0));
  return {to_text(Json(static_cast<std::int64_t>(low))),
          to_text(Json(static_cast<std::int64_t>(low + width)))};
}

// The scenario's text with new values for ranges that do not hold: they keep their width, with the new value
// in the middle; counts become the new ones.
std::string with_updated_ranges(std::string text, const std::vector<Expectation>& ranges) {
  constexpr std::string_view kContacts = "contacts/";
  for (const Expectation& expectation : ranges) {
    const std::string_view rule = expectation.rule;
    const bool is_count = rule.starts_with(kContacts);
    std::vector<std::string_view> keys = {"expect"};
    if (is_count) keys.push_back(kContacts.substr(0, kContacts.size() - 1));
    keys.push_back(is_count ? rule.substr(kContacts.size()) : rule);
    text = with_elements(text, keys,
                         ends_around(std::get<double>(expectation.measured), *expectation.range, is_count));
  }
  return text;
}

void update_expect(const Core& core, bool updates_ranges, Scenario& scenario, Blessing& blessing) {
  const std::string hash = hex(blessing.summary.state_hash);
  const std::string text = read_scenario_text(blessing.path);
  std::string updated = with_value(text, {"expect", "state_hash"}, '"' + hash + '"');
  blessing.has_new_hash = updated != text;
  if (updates_ranges) {
    blessing.updated = broken_expectations(core, scenario, blessing.summary, reference_model(core));
    std::erase_if(blessing.updated, std::not_fn(is_updatable_range));
    updated = with_updated_ranges(std::move(updated), blessing.updated);
  }
  scenario = parse_scenario_file(updated, blessing.path);
  if (updated != text) blessing.scenario_text = std::move(updated);
}

void plan(const Core& core, Blessing& blessing, const BlessOptions& options, const OutputGuard& guard) {
  Scenario scenario = load_scenario(blessing.path);
  require_measurable(core, blessing.path, scenario);
  blessing.golden = place_of(blessing.path, options.golden_folder);
  blessing.golden_folder = golden_folder_of(blessing.path, options.golden_folder);
  require_usable(*blessing.golden, guard);
  compare(core, scenario, blessing);
  if (options.updates_hash || options.updates_ranges)
    update_expect(core, options.updates_ranges, scenario, blessing);
  if (blessing.scenario_text) require_writable(blessing.path);
  require_expected(core, scenario, blessing);
  if (blessing.writes_golden_file())
    for (const std::string& path : {blessing.golden->h5_path, blessing.golden->txt_path})
      require_writable(path);
  if (!blessing.writes() || !blessing.differs_in || *blessing.differs_in <= options.accepted) return;
  blessing.status = BlessStatus::refused;
  blessing.exit_code = ExitCode::disagreed;
}

void write_golden_file(const Core& core, const Blessing& blessing, const std::string& reason) {
  const auto& [h5_path, txt_path, is_reserved, folder] = *blessing.golden;
  Scenario scenario = load_scenario(blessing.path);
  if (blessing.scenario_text) scenario = parse_scenario_file(*blessing.scenario_text, blessing.path);
  const FreshRun fresh = play_for_golden(core, scenario, core);
  if (blessing.keeps_h5)
    return write_text_file(txt_path, summary_of(core, fresh, reason, file_checksum(h5_path)));
  std::error_code error;
  fs::create_directories(fs::path(h5_path).parent_path(), error);
  AtomicFile rows(h5_path);
  AtomicFile summary(txt_path);
  write_golden(rows, h5_path, fresh.run);
  summary.write(summary_of(core, fresh, reason, file_checksum(rows.part_path())));
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

void write(const Core& core, Blessing& blessing, const BlessOptions& options) {
  assert(blessing.writes());
  attempt(blessing, [&] {
    if (blessing.writes_golden_file()) write_golden_file(core, blessing, options.reason);
    if (blessing.scenario_text) write_text_file(blessing.path, *blessing.scenario_text);
  });
}

}  // namespace hyrax
