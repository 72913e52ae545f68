// Places labels where they cover as little of the picture, and of one another, as possible.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tools/report/run_plot.h"

namespace hyrax {

class LabelPlacer {
 public:
  struct Point {
    double x = 0.0;  ///< On the canvas, in px of the SVG.
    double y = 0.0;
  };

  explicit LabelPlacer(const RunPlot& plot) : plot_(plot) {}

  /// What lies between the two points should not be covered.
  void avoid(Point from, Point to);
  /// The command that draws `words` around the best of `centres`: inside the plot, off other labels, and
  /// then over the least of what should not be covered; of equals the first.
  /// REQUIRES: a centre.
  [[nodiscard]] std::string put(std::string_view words, const std::vector<Point>& centres);

  [[nodiscard]] static double width(std::string_view words);

 private:
  struct Area {
    double left, top, right, bottom;
  };
  static Area area(std::string_view words, Point centre);
  [[nodiscard]] double cost(const Area& label) const;

  const RunPlot& plot_;
  std::vector<Point> avoided_;
  std::vector<Area> labels_;
};

}  // namespace hyrax
