// Which window and sprite sizes a row was made with.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/scenario/scenario.h"

namespace hyrax {

/// The sizes of a run, by row.
class SizesInForce {
 public:
  struct Change {
    std::int64_t first_step = 0;  ///< Row number.
    Size window;
    Size sprite;
  };

  /// @param frames the frame of each of the scenario's events.
  SizesInForce(const Scenario& scenario, const std::vector<std::int64_t>& frames);

  /// In order of rows; the first is of row 0.
  [[nodiscard]] const std::vector<Change>& changes() const { return changes_; }
  [[nodiscard]] const Change& at(std::int64_t step) const;

 private:
  std::vector<Change> changes_;
};

}  // namespace hyrax
