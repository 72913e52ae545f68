// Reads when events happen, of scenarios of any core, and checks their order.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/scenario/schedule.h"
#include "tools/files/scenario_head.h"

namespace hyrax {

/// What an action does to the frames that follow.
struct EventEffect {
  enum class Hold { unchanged, held, let_go };
  Hold hold = Hold::unchanged;
  std::optional<double> hitch_dt_s = {};
};
/// The actions of a kind of scenario.
struct ActionRules {
  std::vector<std::string_view> names = {};
  std::string held_already = {};  ///< The error if it is.
  std::string not_held = {};
  /// Reads the action of that name for an event, both by their number.
  std::function<EventEffect(const JsonPlace& here, std::size_t event, std::size_t action)> read = {};
};
/// The times of all events, each of which must have one and exactly one action; their order and holds, and
/// whether they have a frame, are checked.
[[nodiscard]] std::vector<EventTime> read_events(const JsonPlace& here, const FramesRead& frames,
                                                 const Clock& clock, const ActionRules& rules);

}  // namespace hyrax
