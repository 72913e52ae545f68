// What a command found of a scenario and its golden file, for any core.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/compare/comparison.h"
#include "sim/compare/expectations.h"
#include "tools/files/check_status.h"
#include "tools/files/golden_place.h"
#include "tools/files/json.h"
#include "tools/report/svg.h"

namespace hyrax {

struct DifferenceGroup;

/// How far a run is from its golden file's.
struct Deviation {
  std::optional<DifferenceClass> difference = {};
  std::optional<double> px = {};  ///< Nothing where no value is in px, or it cannot be told.
  ContactCounts contacts = {};
  std::optional<double> rest_shift_px = {};  ///< Where both runs have settled.
};

/// Its path is that of an unreferenced golden file without its suffix, if it is of one. The state hash is
/// then as its summary states it.
struct ScenarioVerdict {
  std::string path;           ///< Of the scenario as given.
  std::string golden_option;  ///< --golden as given; empty if it was not.
  std::optional<GoldenPlace> golden;
  std::string golden_folder;  ///< Has the accepted core; empty: no scenario, or in no library.
  CheckStatus status = CheckStatus::agreed;
  bool is_scenario = true;    ///< No golden file without a scenario, and no golden folder.
  bool has_golden = false;    ///< Its golden file exists.
  bool is_undecided = false;  ///< The golden file must be read.
  double seconds = 0.0;
  /// What does not hold, whatever it is compared with, as that the run becomes non-finite: no result to
  /// bless.
  std::vector<std::string> faults;
  bool is_non_finite = false;       ///< That is one.
  std::vector<Expectation> broken;  ///< Expectations that do not hold.
  bool expects_hash = false;        ///< `expect` has a state hash.
  std::string state_hash;           ///< Of the run, 32 hex digits; empty: not known.
  /// What is wrong with the golden file, where that was changed since it was blessed, and nothing is known of
  /// its run.
  std::string golden_fault;
  std::string to_restore;   ///< The files of one that was changed.
  bool is_repeated = true;  ///< The run was played twice, and the bits were the same.
  std::string remark;       ///< On a run that differs.
  std::string error;        ///< Of a failed one.
  ExitCode exit_code = ExitCode::agreed;
  Sheet picture = {};  ///< Of its run, for a sheet; empty: not drawn.

  const DifferenceGroup* group = nullptr;  ///< In which its run differs, if it does; set by `explain`.
  /// The other half of a renamed scenario: of one whose golden file is missing the unreferenced golden file
  /// with its run, and the other way round. Set by `explain`.
  const ScenarioVerdict* renamed = nullptr;

  ScenarioVerdict() = default;
  ScenarioVerdict(const ScenarioVerdict&) = default;
  ScenarioVerdict& operator=(const ScenarioVerdict&) = default;
  ScenarioVerdict(ScenarioVerdict&&) = default;
  ScenarioVerdict& operator=(ScenarioVerdict&&) = default;
  virtual ~ScenarioVerdict() = default;

  /// Whether its run is another one than its golden file's.
  [[nodiscard]] virtual bool differs() const = 0;
  [[nodiscard]] virtual Deviation deviation() const = 0;
  /// What a user of the program would see of it. One line.
  [[nodiscard]] virtual std::string consequence() const = 0;
  /// Where it begins, as "step 3, field x"; empty: not known.
  [[nodiscard]] virtual std::string first_difference() const = 0;
  /// How it differs: complete lines, indented by two.
  [[nodiscard]] virtual std::string differences_text(bool lists_all) const = 0;
  /// {"class", "max_px", ...}.
  [[nodiscard]] virtual Json::Object differences_json() const = 0;
};

/// {"scenario", "status", "class", "max_px", ...}: how a run differs from its golden file, the first members
/// of an entry of "results" of check and bless. @param is_compared else there are no distances.
[[nodiscard]] inline Json::Object result_of(const ScenarioVerdict& scenario, std::string_view status,
                                            bool is_compared) {
  Json::Object entry = scenario.differences_json();
  if (!is_compared)
    for (auto& [key, value] : entry) value = key == "max" ? Json(Json::Object()) : Json();
  entry.insert(entry.begin(), {{"scenario", scenario.path}, {"status", status}});
  return entry;
}

}  // namespace hyrax
