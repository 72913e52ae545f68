// Frames of one stretch through physics::update, packed into rows.
//
// The one place of the replay that sees the core. A stretch has no input: its sizes and whether the
// sprite is held do not change.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/scenario/scenario.h"
#include "sim/trajectory/contact.h"
#include "sim/trajectory/row_block.h"

namespace hyrax {

struct Body {
  double x_px = 0.0;
  double y_px = 0.0;
  double vx_px_per_s = 0.0;
  double vy_px_per_s = 0.0;
};

/// What to play.
struct Stretch {
  Size window;
  Size sprite;
  bool is_held = false;
  std::uint8_t contact_before = 0;  ///< Contact byte of the row before the first frame.
  const double* dt_s = nullptr;     ///< One dt, or one a frame.
  bool is_dt_fixed = true;
  std::int64_t frames = 0;
  const Body* anchor = nullptr;  ///< Ends the stretch early at the row whose state has these bits.
};

/// A contact that began in row `offset` of the stretch, without its steps and time.
struct BegunContact {
  std::int64_t offset = 0;
  Contact contact;
};

/// What happened; reused from stretch to stretch.
struct StretchLog {
  std::int64_t frames = 0;  ///< Played.
  bool met_anchor = false;
  bool had_friction = false;  ///< A ground contact met a sprite that slid.
  WallCounts clamped_steps{};
  std::int64_t rest_steps = 0;
  std::vector<BegunContact> begun;  ///< By offset; in a corner x before y.
};

/// Plays the stretch, moves `body` and appends a row a frame to `rows`.
/// REQUIRES: stretch.frames <= rows.room().
void play(const Stretch& stretch, Body& body, RowBlock& rows, StretchLog& log);

}  // namespace hyrax
