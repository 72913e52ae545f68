// Plays a scenario by a core that describes itself, frame by frame, into any number of sinks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "sim/compare/equal_times.h"
#include "sim/described/described_core.h"
#include "sim/described/described_scenario.h"
#include "sim/scenario/frame_clock.h"
#include "sim/trajectory/state_hash.h"

namespace hyrax {

/// A row, while it is handed on. Values in declared order.
struct DescribedRow {
  std::int64_t step = 0;
  double t_s = 0.0;
  double dt_s = 0.0;
  std::span<const Word> state = {};
  std::span<const Word> outputs = {};
  std::span<const std::uint8_t> contacts = {};  ///< 0 or 1.
};

/// A contact: consecutive rows with the flag. A held frame ends it.
struct DescribedContact {
  std::size_t contact = 0;
  std::int64_t step = 0;
  std::int64_t last_step = 0;
  double t_s = 0.0;  ///< Of its first row.
  bool operator==(const DescribedContact&) const = default;
};
/// By which contacts are in order: its first step, which one it is, its last step.
[[nodiscard]] inline auto order_of(const DescribedContact& contact) {
  return std::tuple(contact.step, contact.contact, contact.last_step);
}

/// What a run goes on from at a row: the first row of a block of 4,096.
struct DescribedKeyframe {
  std::int64_t step = 0;
  Timeline timeline = {};
  std::vector<Word> state = {};
  std::vector<Word> inputs = {};
  bool is_held = false;
  bool operator==(const DescribedKeyframe&) const = default;
};

struct DescribedBlock {
  Digest digest{};
  DescribedKeyframe keyframe = {};
};

/// Receives a run as it is played.
class DescribedSink {
 public:
  DescribedSink() = default;
  DescribedSink(const DescribedSink&) = delete;
  DescribedSink& operator=(const DescribedSink&) = delete;
  virtual ~DescribedSink() = default;

  /// Every row, in order.
  virtual void row(const DescribedRow& /*row*/) {}
  /// A contact that has ended, at the latest when the run ends. At most kContactsRecordedMax.
  virtual void contact(const DescribedContact& /*contact*/) {}
  virtual void block(const DescribedBlock& /*block*/) {}
};

struct PropertyOutcome {
  bool holds = true;                      ///< Of `sometimes`: whether it was shown.
  std::optional<std::int64_t> step = {};  ///< The first row in which it is broken, or shown,
  double t_s = 0.0;                       ///< and its time.
};

/// Why a run ended before its last frame.
struct EarlyEnd {
  std::int64_t step = 0;  ///< The row that could not be made; of a state that is not finite, that row.
  std::string what = {};  ///< A sentence without the row, as "a.x_px is not finite".
  bool is_non_finite = false;
};

struct DescribedSummary {
  std::int64_t steps = 0;  ///< Frames played.
  double simulated_s = 0.0;
  std::vector<std::int64_t> contacts = {};    ///< Of each, how many.
  std::vector<Word> final = {};               ///< The state in the last row.
  std::vector<std::uint8_t> inputs_set = {};  ///< 0 or 1: by a scenario's events, start or arrays.
  std::vector<std::uint8_t> actions_done = {};
  std::vector<PropertyOutcome> properties = {};
  std::optional<double> at_rest_since_s = {};  ///< Nothing, too, if no value is in px.
  Digest state_hash{};
  std::optional<EarlyEnd> early_end = {};
};

/// The rows before a description's check ends where the check is not asked for the whole run.
inline constexpr std::int64_t kCheckedRowsMax = 4096;

/// Plays the scenario to its end, or until the run ends early. Exceptions of the core end the run.
/// REQUIRES: a scenario read for the core's description.
[[nodiscard]] DescribedSummary play(const DescribedCore& core, const DescribedScenario& scenario,
                                    std::span<DescribedSink* const> sinks);

/// What the check of the description found wrong, in one sentence, as "the state is not complete: set from
/// row 256, a.y_px differs at row 301; a member that changes is not declared"; nothing: it is complete, or it
/// has undeclared parts. Plays the scenario again: a second run, copies, and fresh cores that are set, in
/// this order.
/// @param rows_max of the rows that are held.
/// @param played a run before, which it does not look behind; one of at most rows_max frames must have the
/// same state hash, too.
[[nodiscard]] std::optional<std::string> description_fault(const DescribedCore& core,
                                                           const DescribedScenario& scenario,
                                                           std::int64_t rows_max = kCheckedRowsMax,
                                                           const DescribedSummary* played = nullptr);

/// How a run differs from one that is stopped and resumed: at a third, at two thirds and where the first
/// event past row 0 is; as "stopped at row 20 and resumed, a.y_px differs at row 37". Nothing: not at all.
/// @param rows_max of the rows that are held, as of a run that ended early.
[[nodiscard]] std::optional<std::string> resumed_fault(const DescribedCore& core,
                                                       const DescribedScenario& scenario,
                                                       std::int64_t rows_max);

/// The bytes of a row, for hashes: dt, the state's words, the contact flags.
void pack_row(const DescribedRow& row, std::vector<std::byte>& bytes);

struct KeptRow {
  std::int64_t step = 0;
  double t_s = 0.0;
  double dt_s = 0.0;
  std::vector<Word> state = {};
  std::vector<std::uint8_t> contacts = {};
};

/// One after another, all of one core.
struct DescribedRows {
  std::vector<std::int64_t> step = {};
  std::vector<double> t_s = {};
  std::vector<double> dt_s = {};
  std::vector<Word> state = {};             ///< Row after row, as many values each.
  std::vector<std::uint8_t> contacts = {};  ///< As `state`.

  [[nodiscard]] std::size_t size() const { return step.size(); }
  /// REQUIRES: index < size().
  [[nodiscard]] KeptRow row(std::size_t index) const {
    const auto part = [&](const auto& values) {
      const std::size_t width = values.size() / size();
      const auto begin = values.begin() + static_cast<std::ptrdiff_t>(index * width);
      return std::vector(begin, begin + static_cast<std::ptrdiff_t>(width));
    };
    return {step[index], t_s[index], dt_s[index], part(state), part(contacts)};
  }
  /// Its outputs are not kept.
  void append(const auto& row) {
    step.push_back(row.step);
    t_s.push_back(row.t_s);
    dt_s.push_back(row.dt_s);
    state.insert(state.end(), row.state.begin(), row.state.end());
    contacts.insert(contacts.end(), row.contacts.begin(), row.contacts.end());
  }
};

using DescribedRowBatches = BatchesOf<DescribedRows>;

}  // namespace hyrax
