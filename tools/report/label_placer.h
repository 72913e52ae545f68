// Places labels where they cover as little of the picture, and of one another, as possible.
#pragma once

#include <string_view>
#include <vector>

namespace hyrax {

class LabelPlacer {
 public:
  struct Point {
    double x = 0.0;  ///< On the canvas, in px of the SVG.
    double y = 0.0;
  };
  struct Area {
    double left, top, right, bottom;
  };

  /// @param inside where labels should be.
  explicit LabelPlacer(const Area& inside) : inside_(inside) {}

  /// What lies between the two points should not be covered.
  void avoid(Point from, Point to);
  /// The centre of a label: the best of `centres`: inside, off other labels, and then over the least of what
  /// should not be covered; of equals the first. REQUIRES: a centre.
  [[nodiscard]] Point place(std::string_view text, const std::vector<Point>& centres);

  /// Centres of a label beside a point, the nearest first.
  [[nodiscard]] static std::vector<Point> centres_around(Point at, std::string_view text);
  /// The place of a label, by its centre, that is nearest to a point.
  [[nodiscard]] static Point nearest_of(std::string_view text, Point centre, Point to);
  /// Of a label, in px of the SVG.
  [[nodiscard]] static double width(std::string_view text);

 private:
  static Area area(std::string_view text, Point centre);
  [[nodiscard]] double cost(const Area& label) const;

  Area inside_;
  std::vector<Point> avoided_;
  std::vector<Area> labels_;
};

}  // namespace hyrax
