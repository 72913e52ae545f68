// What `bless` does with one scenario: planned for all of them before the first is written.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/compare/expectations.h"
#include "sim/core/core.h"
#include "tools/app/golden/golden_pair.h"

namespace hyrax {

struct BlessOptions {
  std::string reason;
  std::string golden_folder;                             ///< As given with --golden; empty if it was not.
  DifferenceClass accepted = DifferenceClass::rounding;  ///< The widest class that may be blessed.
  bool updates_ranges = false;                           ///< And what else of `expect` is_updatable.
  bool updates_hash = false;                             ///< Puts the new state hash into the scenario file.
};

struct Blessing : PairVerdict {
  enum class Status { fresh, changed, unchanged, refused, failed };
  Status status = Status::unchanged;
  bool keeps_h5 = false;                      ///< Only the summary is written.
  std::string unreadable;                     ///< Why the golden file cannot be read; else empty.
  std::optional<DifferenceClass> differs_in;  ///< What has to be accepted; nothing: nothing has to be.
  std::optional<std::string> scenario_text;   ///< The scenario file with its new `expect`, where it changes.
  std::vector<Expectation> updated;           ///< What else than the state hash changes there.

  [[nodiscard]] bool has_failed() const { return status == Status::failed; }
  [[nodiscard]] bool writes_golden_file() const {
    return status == Status::fresh || status == Status::changed;
  }
  [[nodiscard]] bool writes() const {
    return writes_golden_file() || (status == Status::unchanged && scenario_text);
  }
};

[[nodiscard]] std::string_view name_of(Blessing::Status status);

/// Plans every scenario, each once; refuses those that share a golden file, whose expectations do not hold,
/// whose difference is wider than accepted, or whose files cannot be written. Nothing is written. An error is
/// printed, and becomes a failed blessing.
[[nodiscard]] std::vector<Blessing> plan_blessings(const Core& core, const std::vector<std::string>& paths,
                                                   const BlessOptions& options);

/// Writes what was planned: the summary, then the rows, then the scenario file. An error is printed, and the
/// blessing has failed.
/// REQUIRES: blessing.writes().
void write(const Core& core, Blessing& blessing, const BlessOptions& options);

}  // namespace hyrax
