// What a picture of a run shows, in px of its window, and the picture, to scale.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/scenario/scenario.h"
#include "sim/trajectory/columns.h"
#include "sim/trajectory/row.h"
#include "tools/report/svg.h"

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

struct PathPoint {
  double x_px = 0.0;
  double y_px = 0.0;
  double speed_px_per_s = 0.0;
};

enum class StrokeKind {
  flown,
  moved,       ///< By an input, or by a wall that moved.
  unrecorded,  ///< Between rows that are not consecutive, and too far apart to know the path.
};

/// One line without a break.
struct Stroke {
  StrokeKind kind = StrokeKind::flown;
  std::vector<PathPoint> points;
};

struct RunPath {
  std::vector<Stroke> strokes;
  /// At every frame whose number is a multiple of `frames_per_bead`; left out where they would overlap.
  std::vector<PathPoint> beads;
  std::int64_t frames_per_bead = 0;
  double speed_px_per_s_max = 0.0;
  /// If one throw is so fast that everything else would have the same colour: where the logarithmic colour
  /// scale begins; else 0.
  double speed_px_per_s_low = 0.0;
  std::optional<double> cut_at_s;  ///< The path is cut at this time, as it has too many points.
};

/// A path has no more points than this.
inline constexpr std::size_t kPathPointsMax = 1500;
inline constexpr std::size_t kBeadsMax = 200;

/// Leaves out rows closer than `detail_px` to the last one kept, and rows that are not finite. With too many
/// points left, the distance is up to eight times as large; a path that is still too long is cut.
[[nodiscard]] RunPath make_run_path(const Columns& rows, const SizesInForce& sizes, double detail_px);

/// A velocity given to the sprite: at the start, by a fling or by a release.
struct Throw {
  double x_px = 0.0;  ///< The sprite's centre.
  double y_px = 0.0;
  Velocity velocity;
};

/// What the picture labels with its time: an input of any kind.
struct TimedInput {
  std::string_view what;
  double t_s = 0.0;
  double x_px = 0.0;  ///< The sprite's centre; of a window its right edge,
  double y_px = 0.0;  ///< and half its height.
};

/// Whether two outlines differ by less than `tolerance` times the sides of the first.
[[nodiscard]] bool nearly_cover(const Box& a, const Box& b, double tolerance);

/// A contact: a bounce, or a resting contact, which the picture shows by the floor below it alone.
struct Touch {
  Wall wall = Wall::ground;
  Box sprite;
  bool is_resting = false;
};

struct RunScene {
  std::vector<Size> windows;  ///< Each once, in order; of many some, with the first and the last.
  std::optional<Box> start, end;
  std::optional<SvgPoint> not_finite;  ///< Centre before the row that is not finite, if that is in view.
  std::vector<Touch> touches;          ///< The first kTouchesShownMax.
  std::vector<Box> ghosts;             ///< Outlines of bounces, without those that nearly cover one another.
  WallCounts bounces{};                ///< How many there are, drawn or not.
  std::vector<Throw> throws;           ///< The first kThrowsShownMax.
  std::vector<TimedInput> inputs;      ///< The first kInputsLabelledMax.
  RunPath path;
  /// Contains the windows, and the sprite while it is near them; of a window that is much longer than wide,
  /// the part that the sprite visits.
  Box view;
};

inline constexpr std::size_t kTouchesShownMax = 30;
inline constexpr std::size_t kThrowsShownMax = 12;
inline constexpr std::size_t kInputsLabelledMax = 12;
inline constexpr std::size_t kWindowsShownMax = 12;

/// @param view_parts the resolution: the path shows details larger than the view's longer side divided by it.
/// REQUIRES: rows and contacts are of this scenario, whose events have frames.
[[nodiscard]] RunScene make_run_scene(const Scenario& scenario, const Columns& rows,
                                      const std::vector<Contact>& contacts, double view_parts);

/// The text of an SVG file that shows a run: the path of the sprite's centre coloured by speed, the
/// sprite's outline at the start, at the first bounces and at the end, the walls where it touched
/// them, an arrow for every velocity that it was given, and its inputs with their times. x and y have the
/// same scale. The same run gives the same text; its length has a bound, however long the run is.
/// @param rows in order of steps, with row 0 first; rows that are not finite are left out. Missing rows are
/// drawn as a dotted line.
/// @param bounces all bounces by wall, if `contacts` has only the first contacts: 30 are drawn. Counted from
/// `contacts` if left out. Which of those are bounces is judged by the rows.
/// REQUIRES: rows and contacts are of this scenario, whose events have frames.
[[nodiscard]] std::string run_svg(const Scenario& scenario, const Columns& rows,
                                  const std::vector<Contact>& contacts,
                                  const std::optional<WallCounts>& bounces = std::nullopt);

/// The same for a contact sheet: window, path and contacts alone, without texts; as wide or as high as a
/// panel's picture.
/// REQUIRES: as run_svg's.
[[nodiscard]] Sheet run_panel(const Scenario& scenario, const Columns& rows,
                              const std::vector<Contact>& contacts);

}  // namespace hyrax
