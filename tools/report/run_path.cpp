#include "tools/report/run_scene.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hyrax {
namespace {

constexpr double kCoarsest = 8.0;  // Times the requested detail.

PathPoint centre_of(const Row& row, const Size& sprite) {
  return {row.x_px + sprite.width_px / 2.0, row.y_px + sprite.height_px / 2.0,
          std::hypot(row.vx_px_per_s, row.vy_px_per_s)};
}

double distance_px(const PathPoint& a, const PathPoint& b) {
  return std::hypot(a.x_px - b.x_px, a.y_px - b.y_px);
}

// A round number of frames that take a tenth of a second or more; 0 if the first rows are not consecutive.
std::int64_t frames_per_bead(const Columns& rows) {
  if (rows.size() < 2 || rows.step[1] != rows.step[0] + 1) return 0;
  const double mean_dt_s = rows.t_s.back() / static_cast<double>(rows.step.back());
  for (const std::int64_t frames : {1, 2, 3, 4, 5, 6, 8, 10, 12, 15, 20, 24, 30, 60})
    if (static_cast<double>(frames) * mean_dt_s >= 0.0999) return frames;
  return 0;
}

class PathMaker {
 public:
  PathMaker(const SizesInForce& sizes, double detail_px, std::int64_t frames_per_bead)
      : sizes_(sizes), detail_px_(detail_px) {
    path_.frames_per_bead = frames_per_bead;
  }

  // Returns false if there are too many points.
  bool add_row(const Row& row) {
    if (!is_finite(state_of(row))) {
      end_stroke();
      return true;
    }
    const PathPoint point = centre_of(row, sizes_.at(row.step).sprite);
    if (!last_row_) {
      begin_stroke(StrokeKind::flown, point);
    } else if (const StrokeKind kind = kind_of(row, point); kind != path_.strokes.back().kind) {
      keep_last();
      begin_stroke(kind, last_point_);
    }
    const bool is_corner = last_row_ && last_row_->contact != row.contact && row.contact != 0;
    last_row_ = row;
    last_point_ = point;
    if (distance_px(point, path_.strokes.back().points.back()) >= (is_corner ? detail_px_ / 3 : detail_px_))
      keep_last();
    add_bead(row);
    return count_ < kPathPointsMax;
  }

  RunPath result(bool is_cut) {
    if (is_cut) path_.cut_at_s = last_row_->t_s;
    end_stroke();
    std::erase_if(path_.strokes, [](const Stroke& stroke) { return stroke.points.size() < 2; });
    if (path_.beads.size() >= kBeadsMax) path_.beads.clear();
    return std::move(path_);
  }

 private:
  // Whether the sprite's own speed explains the distance from the last row. A wall reduces the speed within a
  // step, so the greater of the two speeds is used.
  [[nodiscard]] StrokeKind kind_of(const Row& row, const PathPoint& point) const {
    constexpr double kSlack_px = 2.0;
    const double moved_px = distance_px(point, last_point_);
    if (row.step > last_row_->step + 1 && moved_px > 20 * detail_px_) return StrokeKind::unrecorded;
    const double speed_px_per_s = std::max(point.speed_px_per_s, last_point_.speed_px_per_s);
    const double flown_px_max = 1.1 * speed_px_per_s * (row.t_s - last_row_->t_s) + kSlack_px;
    return moved_px <= flown_px_max ? StrokeKind::flown : StrokeKind::moved;
  }
  void begin_stroke(StrokeKind kind, const PathPoint& point) {
    path_.strokes.push_back({kind, {}});
    add(point);
  }
  void keep_last() {
    const PathPoint& before = path_.strokes.back().points.back();
    if (before.x_px != last_point_.x_px || before.y_px != last_point_.y_px) add(last_point_);
  }
  void add(const PathPoint& point) {
    path_.strokes.back().points.push_back(point);
    path_.speed_px_per_s_max = std::max(path_.speed_px_per_s_max, point.speed_px_per_s);
    ++count_;
  }
  void add_bead(const Row& row) {
    if (path_.frames_per_bead == 0 || row.step % path_.frames_per_bead != 0) return;
    if (path_.strokes.back().kind != StrokeKind::flown || path_.beads.size() >= kBeadsMax) return;
    const bool has_room =
        path_.beads.empty() || distance_px(last_point_, path_.beads.back()) >= 4 * detail_px_;
    if (has_room) path_.beads.push_back(last_point_);
  }
  void end_stroke() {
    if (last_row_) keep_last();
    last_row_.reset();
  }

  const SizesInForce& sizes_;
  double detail_px_;
  RunPath path_;
  std::size_t count_ = 0;
  std::optional<Row> last_row_;
  PathPoint last_point_;
};

// A power of ten below most of the path's speeds.
double low_end_of_colours(const RunPath& path) {
  constexpr double kTimesTheMedian = 8.0;
  std::vector<double> speeds;
  for (const Stroke& stroke : path.strokes)
    for (const PathPoint& point : stroke.points)
      if (point.speed_px_per_s >= 1.0) speeds.push_back(point.speed_px_per_s);
  if (speeds.empty()) return 0.0;
  std::sort(speeds.begin(), speeds.end());
  if (path.speed_px_per_s_max < kTimesTheMedian * speeds[speeds.size() / 2]) return 0.0;
  return std::pow(10.0, std::floor(std::log10(speeds[speeds.size() / 8])));
}

RunPath path_in_detail(const Columns& rows, const SizesInForce& sizes, double detail_px) {
  PathMaker maker(sizes, detail_px, frames_per_bead(rows));
  bool has_room = true;
  for (std::size_t i = 0; i < rows.size() && has_room; ++i) has_room = maker.add_row(rows.row(i));
  return maker.result(!has_room);
}

}  // namespace

RunPath make_run_path(const Columns& rows, const SizesInForce& sizes, double detail_px) {
  RunPath path = path_in_detail(rows, sizes, detail_px);
  for (double coarser = 2.0; path.cut_at_s && coarser <= kCoarsest; coarser *= 2.0)
    path = path_in_detail(rows, sizes, coarser * detail_px);
  path.speed_px_per_s_low = low_end_of_colours(path);
  return path;
}

}  // namespace hyrax
