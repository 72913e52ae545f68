// Places labels where they cover as little of the picture, and of one another, as possible.
#pragma once

#include <string_view>
#include <vector>

#include "tools/report/svg.h"

namespace hyrax {

class LabelPlacer {
 public:
  static constexpr double kSize = 12.0;  ///< Of the labels' letters, in px.

  /// @param inside where all labels are.
  explicit LabelPlacer(const Box& inside) : inside_(inside) {}

  /// What lies between the two points should not be covered.
  void avoid(SvgPoint from, SvgPoint to);
  void avoid_line(const std::vector<SvgPoint>& points);
  void avoid_outline(const Box& box);
  /// How much of it a line of some width would cover, between the two points.
  [[nodiscard]] double covered_by(SvgPoint from, SvgPoint to) const;
  /// The centre of a label: the best of `centres`, moved inside if need be: off other labels, and then over
  /// the least of what should not be covered; of equals the first. REQUIRES: a centre.
  [[nodiscard]] SvgPoint place(std::string_view text, const std::vector<SvgPoint>& centres);
  /// Places a label beside a point and draws it, with a line to its point if that is not near.
  /// @param is_optional nothing is drawn where it would cover another label.
  void draw_beside(Svg& svg, SvgPoint at, std::string_view text, Tone tone, bool is_optional = false);

  [[nodiscard]] static double width(std::string_view text) { return text_width(text, kSize) + 4.0; }
  [[nodiscard]] static Lettering lettering(Tone tone) {
    return {.size = kSize, .tone = tone, .side = Side::middle, .has_edge = true};
  }

 private:
  static constexpr double kOther = 1e4;  // What it costs to cover another label: more than any path.

  static Box area(std::string_view text, SvgPoint centre);
  [[nodiscard]] SvgPoint moved_inside(const Box& label) const;
  [[nodiscard]] double cost(const Box& label) const;

  Box inside_;
  std::vector<SvgPoint> avoided_;
  std::vector<Box> labels_;
};

}  // namespace hyrax
