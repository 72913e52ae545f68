#include "tools/report/label_placer.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace hyrax {

void LabelPlacer::avoid(Point from, Point to) {
  constexpr double kApart = 3.0;
  constexpr double kPartsMax = 1000.0;  // Of a line that leads far outside.
  const double parts =
      std::clamp(std::ceil(std::hypot(to.x - from.x, to.y - from.y) / kApart), 1.0, kPartsMax);
  for (double part = 0.0; part <= parts; part += 1.0)
    avoided_.push_back({from.x + (to.x - from.x) * part / parts, from.y + (to.y - from.y) * part / parts});
}

double LabelPlacer::width(std::string_view words) { return 6.6 * static_cast<double>(words.size()) + 4.0; }

LabelPlacer::Area LabelPlacer::area(std::string_view words, Point centre) {
  constexpr double kHalfHeight = 7.5;
  const double half = width(words) / 2;
  return {centre.x - half, centre.y - kHalfHeight, centre.x + half, centre.y + kHalfHeight};
}

double LabelPlacer::cost(const Area& label) const {
  constexpr double kOther = 1e4;  // More than any path.
  double cost = 0.0;
  if (label.left < RunPlot::kLeft || label.right > RunPlot::kLeft + RunPlot::kWidth ||
      label.top < RunPlot::kTop || label.bottom > RunPlot::kTop + plot_.height)
    cost += kOther;
  for (const Area& other : labels_)
    if (label.left < other.right && other.left < label.right && label.top < other.bottom &&
        other.top < label.bottom)
      cost += kOther;
  for (const Point& point : avoided_)
    if (point.x > label.left && point.x < label.right && point.y > label.top && point.y < label.bottom)
      cost += 1.0;
  return cost;
}

std::string LabelPlacer::put(std::string_view words, const std::vector<Point>& centres) {
  const Point best = *std::min_element(centres.begin(), centres.end(), [&](const Point& a, const Point& b) {
    return cost(area(words, a)) < cost(area(words, b));
  });
  labels_.push_back(area(words, best));
  return fmt::format("set label {} at {} center front font ',12' tc rgb '{}'\n", quoted(words),
                     screen(plot_.canvas, best.x, best.y), style::kInk);
}

}  // namespace hyrax
