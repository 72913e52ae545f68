#include "sim/reference/arc_cutter.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hyrax {
namespace {

// Far beyond the state of any scenario, and far enough below the largest double for squares.
constexpr double kStateMax = 1e100;

bool is_measurable(const Row& row) {
  const double largest = std::max(
      {std::fabs(row.x_px), std::fabs(row.y_px), std::fabs(row.vx_px_per_s), std::fabs(row.vy_px_per_s)});
  return is_finite(state_of(row)) && largest <= kStateMax && row.dt_s >= 0.0 && row.dt_s <= kFrameMax_s;
}

ArcEnd end_at(std::uint8_t contact) {
  for (const Wall wall : kWalls)
    if (touches(contact, wall)) return static_cast<ArcEnd>(wall_index(wall));
  return ArcEnd::ground;
}

}  // namespace

std::optional<Wall> wall_of(ArcEnd end) {
  if (end > ArcEnd::ground) return std::nullopt;
  return kWalls[static_cast<std::size_t>(end)];
}

ArcCutter::ArcCutter(const Scenario& scenario, std::vector<Input> inputs, ArcVisitor& visitor)
    : playback_(scenario, std::move(inputs)), visitor_(visitor) {}

void ArcCutter::row(const Row& row) {
  if (non_finite_step_) return;
  if (!is_measurable(row)) {
    non_finite_step_ = row.step;
    return;
  }
  if (is_flying_) {
    if (row.contact == 0)
      fly(row);
    else
      close(end_at(row.contact), &row);
  }
  if (row.step != 0 && row.contact == 0 && !playback_.has_inputs_after(row.step)) return;
  Row start = row;
  const InputChange change = playback_.apply(start);
  if (is_flying_ && change.ends_arc) close(change.grabs ? ArcEnd::hold : ArcEnd::input, nullptr);
  const bool begins = row.step == 0 || row.contact != 0 || change.ends_arc;
  if (begins && !playback_.is_held()) open(start);
}

void ArcCutter::fly(const Row& row) {
  ++steps_;
  if (steps_ == 1) {
    first_row_ = row;
    return;
  }
  if (steps_ == 2) {
    visitor_.begin(start_);
    visitor_.fly(first_row_);
  }
  visitor_.fly(row);
}

void ArcCutter::open(const Row& start) {
  start_ = {start, playback_.bounds()};
  steps_ = 0;
  is_flying_ = true;
}

void ArcCutter::close(ArcEnd ended_by, const Row* clamped) {
  if (steps_ < 2) ++skipped_arcs_;
  if (steps_ >= 2) visitor_.end(ended_by, clamped);
  if (steps_ == 1 || (steps_ == 0 && clamped != nullptr))
    visitor_.short_arc(start_, steps_ == 1 ? &first_row_ : nullptr, clamped);
  is_flying_ = false;
}

void ArcCutter::finish() {
  if (is_flying_ && steps_ > 0) close(ArcEnd::end, nullptr);
}

}  // namespace hyrax
