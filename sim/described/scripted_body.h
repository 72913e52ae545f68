// A body of a core that describes itself, as it goes through the frames of a scenario.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/described/described_core.h"
#include "sim/described/described_scenario.h"
#include "sim/scenario/frame_clock.h"

namespace hyrax {

[[nodiscard]] inline const ValueList& list_of(const Description& description, SettableList list) {
  return list == SettableList::state    ? description.state
         : list == SettableList::inputs ? description.inputs
                                        : description.parameters;
}

/// What a call of a core's code throws; nothing: it throws nothing.
template <class Call>
[[nodiscard]] std::optional<std::string> thrown_by(const Call& call) {
  try {
    call();
    return {};
  } catch (const std::exception& error) {
    return error.what();
  } catch (...) {
    return "throws what is no std::exception";
  }
}

/// The frame of each event of a scenario of so many frames; `steps`: it is behind them, as at a coarser rate.
[[nodiscard]] std::vector<std::int64_t> event_frames(const DescribedScenario& scenario, std::int64_t steps);

/// The frames of a scenario. Refers to what it is made of.
struct FrameScript {
  FrameScript(const DescribedCore& played_core, const DescribedScenario& played);
  FrameScript(const DescribedCore& core, DescribedScenario&& played) = delete;

  const DescribedCore& core;
  const DescribedScenario& scenario;
  FrameClock clock;
  std::int64_t steps;
  std::vector<std::int64_t> event_frames;
};

/// A value that reads otherwise than it was set.
struct ValueNotHeld {
  SettableList list = {};
  std::size_t place = 0;
};

/// ERRORS of all functions: what the core throws. Refers to the script.
class ScriptedBody {
 public:
  /// A new core at row 0, with all that the scenario gives it before.
  explicit ScriptedBody(const FrameScript& script);
  /// Another body at the same row, with the same frames to come.
  ScriptedBody(const ScriptedBody& other, std::unique_ptr<DescribedBody> body);

  /// Goes on to the next row. REQUIRES: row() < script.steps.
  void play_frame();
  /// Goes on by at least a row, at most `rows_max`, up to the next event, and writes them. REQUIRES: row() <
  /// script.steps; room for the rows.
  void play_frames(std::int64_t rows_max, MadeRows& rows);

  [[nodiscard]] DescribedBody& body() const { return *body_; }
  [[nodiscard]] std::int64_t row() const { return row_; }
  [[nodiscard]] bool is_held() const { return is_held_; }
  /// Of the frame that made this row: dt, and whether an action or `set` was in it.
  [[nodiscard]] double dt_s() const { return dt_s_; }
  [[nodiscard]] bool was_changed() const { return was_changed_; }
  /// 0 or 1 for each contact, in this row. REQUIRES: as many as the description has.
  void contacts(std::span<std::uint8_t> flags) const;

  /// The first value that this row's frame, or the scenario before row 0, set in vain.
  [[nodiscard]] const std::optional<ValueNotHeld>& not_held() const { return not_held_; }

 private:
  void set(SettableList list, const std::vector<GivenValue>& given);
  void set_inputs(const std::vector<GivenValue>& given, std::int64_t frame);
  void begin_frame();
  void apply(const DescribedAction& action);

  const FrameScript& script_;
  std::unique_ptr<DescribedBody> body_;
  std::int64_t row_ = 0;
  std::size_t next_event_ = 0;
  bool is_held_ = false;
  double dt_s_ = 0.0;
  bool was_changed_ = false;
  std::optional<ValueNotHeld> not_held_ = {};
};

}  // namespace hyrax
