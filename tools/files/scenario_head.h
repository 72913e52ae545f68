// What scenarios of all cores share: names, clock, length, recording, and rules of `expect`.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "sim/scenario/scenario.h"
#include "tools/files/json_reader.h"

namespace hyrax {

inline constexpr std::string_view kScenarioFormat = "hyrax-scenario/1";
inline constexpr NumberRule kNotNegativeRule{0.0};
inline constexpr NumberRule kFrameRule{0.0, kFrameMax_s};

// Errors are added to the problems of the place; the values in question are then 0 or missing.

/// Whether the document names another core than `own_core`, which is an error of its own; the other errors of
/// such a document help nobody.
[[nodiscard]] bool is_of_other_core(const JsonPlace& document, std::string_view own_core);

/// `$schema`, `format`, `name`, `description`.
/// @param fallback_name the name if the document has none.
void read_names(const JsonPlace& document, const std::string& fallback_name, ScenarioHead& head);

/// What of a run's frames could be read.
struct FramesRead {
  bool is_clock_good = false;  ///< Without it no `at_s` has a frame.
  std::optional<std::int64_t> steps = {};
};
/// `clock`, and `steps` or `duration_s`.
[[nodiscard]] FramesRead read_frames(const JsonPlace& document, ScenarioHead& head);
/// `record`.
void read_record(const JsonPlace& document, ScenarioHead& head);

/// [low, high]; a number alone is read by the caller. @param or_a_number what the message says of one.
[[nodiscard]] std::optional<Interval> read_interval(const JsonPlace& here,
                                                    const std::string& or_a_number = "");
/// An interval, or a number as upper bound.
[[nodiscard]] std::optional<Interval> read_time(const JsonPlace& here);
/// An interval of whole numbers, or an exact one.
[[nodiscard]] std::optional<Interval> read_count(const JsonPlace& here);
[[nodiscard]] std::optional<std::string> read_hash(const JsonPlace& here);

// The same as JSON.
void add_names(const ScenarioHead& head, Json::Object& document);
void add_frames(const ScenarioHead& head, Json::Object& document);
void add_record(const ScenarioHead& head, Json::Object& document);
[[nodiscard]] Json::Object event_time_json(const std::variant<std::int64_t, double>& when);
[[nodiscard]] Json interval_json(const Interval& interval);
[[nodiscard]] Json time_json(const Interval& interval);
[[nodiscard]] Json count_json(const Interval& interval);

/// Adds a member if there is a value.
template <class Value>
void add_member(Json::Object& object, std::string_view key, const std::optional<Value>& value) {
  if (value) object.emplace_back(key, Json(*value));
}

}  // namespace hyrax
