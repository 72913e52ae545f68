#include "sim/compare/equal_times.h"

namespace hyrax {
namespace {

// Whether a straight line over its frame would show a way that the sprite does not take.
bool jumps(const Input& input) {
  return std::holds_alternative<Place>(input.action) || std::holds_alternative<Grab>(input.action) ||
         std::holds_alternative<Release>(input.action) || std::holds_alternative<Resize>(input.action);
}

std::optional<Row> between(const Row& from, const Row& to, double t_s) {
  if (!is_finite(state_of(to))) return std::nullopt;
  const double part = (t_s - from.t_s) / (to.t_s - from.t_s);
  const auto at = [part](double a, double b) { return a + part * (b - a); };
  Row row = from;
  row.t_s = t_s;
  set_state(row, {at(from.x_px, to.x_px), at(from.y_px, to.y_px), at(from.vx_px_per_s, to.vx_px_per_s),
                  at(from.vy_px_per_s, to.vy_px_per_s)});
  return row;
}

TimeWalk<Columns> walk_of(const TimedRun& run) {
  std::vector<std::int64_t> frames;
  for (const Input& input : run.inputs)
    if (jumps(input)) frames.push_back(input.frame);
  return {run.rows, std::move(frames)};
}

}  // namespace

Distance walk_equal_times(const TimedRun& a, const TimedRun& b, const PairVisit& visit) {
  Distance distance{.is_at_equal_times = true};
  distance.frames_left_out =
      walk_times(walk_of(a), walk_of(b), between, [&](const Row& row_a, const Row& row_b, double t_s) {
        take_larger(distance.largest, {distance_px(state_of(row_a), state_of(row_b)), row_a.step, t_s});
        visit(row_a, row_b);
      });
  return distance;
}

}  // namespace hyrax
