// Numbered work, shared out among processes that do not know of each other.
#pragma once

#include <cstdint>

namespace hyrax {

/// One of `count` parts: every number k with k mod count = index.
struct WorkPart {
  std::int64_t index = 0;
  std::int64_t count = 1;
  bool operator==(const WorkPart&) const = default;

  [[nodiscard]] std::int64_t member(std::int64_t row) const { return index + row * count; }
  /// How many of the numbers 0 .. members - 1 are in this part.
  [[nodiscard]] std::int64_t rows(std::int64_t members) const {
    return index < members ? (members - index - 1) / count + 1 : 0;
  }
};

}  // namespace hyrax
