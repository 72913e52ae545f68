// Why the runs of two programs differ.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace hyrax {

enum class CauseKind : std::uint8_t {
  non_finite,  ///< The run's state becomes non-finite.
  core,        ///< The accepted core gives the golden file's bits, this program's core does not.
  clock,       ///< Other frame times.
  input,       ///< Other inputs, or an input with another effect.
  scenario,    ///< The scenario's own text.
  golden,      ///< The golden file was changed after it was blessed.
  unknown
};
inline constexpr std::array<std::string_view, 7> kCauseKindNames = {"non_finite", "core",   "clock",  "input",
                                                                    "scenario",   "golden", "unknown"};
[[nodiscard]] constexpr std::string_view name_of(CauseKind kind) {
  return kCauseKindNames[static_cast<std::size_t>(kind)];
}

inline constexpr std::string_view kNotRepeated =
    "this program does not repeat itself: played twice, the scenario gives different bits";

struct Cause {
  CauseKind kind = CauseKind::unknown;
  std::string detail;  ///< As "GRAVITY 1200 -> 1250"; of an unknown one, what is known.
  bool operator==(const Cause&) const = default;
};

}  // namespace hyrax
