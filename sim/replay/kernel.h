// Frames of one stretch through physics::update, packed into rows; and inputs through its setters.
//
// The one place of the replay that sees the core. A stretch has no input: its sizes and whether the
// sprite is held do not change.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim/replay/rest_anchor.h"
#include "sim/scenario/scenario.h"
#include "sim/trajectory/contact.h"
#include "sim/trajectory/row_block.h"

namespace hyrax {

/// What to play.
struct Stretch {
  Size window;
  Size sprite;
  bool is_held = false;
  std::uint8_t contact_before = 0;  ///< Contact byte of the row before the first frame.
  const double* dt_s = nullptr;     ///< One dt, or one a frame.
  bool is_dt_fixed = true;
  std::int64_t frames = 0;
  const State* anchor = nullptr;  ///< Ends the stretch early at the row whose state has these bits.
};

/// A wall begins or ceases to clamp in row `offset` of the stretch.
struct ContactChange {
  std::int64_t offset = 0;
  bool begins = false;
  Contact contact;  ///< Of one that ceases only the wall; of one that begins all but steps and time.
};

/// What happened; reused from stretch to stretch.
struct StretchLog {
  std::int64_t frames = 0;  ///< Played.
  bool met_anchor = false;
  bool had_friction = false;            ///< A ground contact met a sprite that slid.
  std::array<std::int64_t, 32> rows{};  ///< By contact byte; of flight none are counted.
  std::vector<ContactChange> changes;   ///< By offset; in a corner x before y.
  std::int64_t moved_offset = -1;       ///< The last row that became the anchor of rest; -1: none.

  [[nodiscard]] std::int64_t rows_with(std::uint8_t contact_bit) const {
    std::int64_t count = 0;
    for (std::size_t contact = 0; contact < rows.size(); ++contact)
      if ((contact & contact_bit) != 0) count += rows[contact];
    return count;
  }
};

/// Plays the stretch: moves `body` and the anchor of rest, and appends a row a frame to `rows`.
/// REQUIRES: stretch.frames <= rows.room().
void play(const Stretch& stretch, State& body, RestAnchor& rest, RowBlock& rows, StretchLog& log);

/// Inputs, as the core takes them: its setVelocity, setPos and resetVelocity.
void fling(Row& row, const Velocity& velocity);
void place(Row& row, const Position& position);
void stop(Row& row);

}  // namespace hyrax
