#include "tools/report/label_placer.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace hyrax {

void LabelPlacer::avoid(Point from, Point to) {
  constexpr double kApart = 3.0;
  constexpr double kPartsMax = 1000.0;  // Of a line that leads far outside.
  const double parts =
      std::clamp(std::ceil(std::hypot(to.x - from.x, to.y - from.y) / kApart), 1.0, kPartsMax);
  for (double part = 0.0; part <= parts; part += 1.0)
    avoided_.push_back({from.x + (to.x - from.x) * part / parts, from.y + (to.y - from.y) * part / parts});
}

double LabelPlacer::width(std::string_view text) { return 6.6 * static_cast<double>(text.size()) + 4.0; }

LabelPlacer::Area LabelPlacer::area(std::string_view text, Point centre) {
  constexpr double kHalfHeight = 7.5;
  const double half = width(text) / 2;
  return {centre.x - half, centre.y - kHalfHeight, centre.x + half, centre.y + kHalfHeight};
}

double LabelPlacer::cost(const Area& label) const {
  constexpr double kOther = 1e4;  // More than any path.
  double cost = 0.0;
  if (label.left < inside_.left || label.right > inside_.right || label.top < inside_.top ||
      label.bottom > inside_.bottom)
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

LabelPlacer::Point LabelPlacer::place(std::string_view text, const std::vector<Point>& centres) {
  assert(!centres.empty());
  const Point best = *std::min_element(centres.begin(), centres.end(), [&](const Point& a, const Point& b) {
    return cost(area(text, a)) < cost(area(text, b));
  });
  labels_.push_back(area(text, best));
  return best;
}

std::vector<LabelPlacer::Point> LabelPlacer::centres_around(Point at, std::string_view text) {
  const double half = width(text) / 2 + 6;
  std::vector<Point> centres;
  for (const double away : {14.0, 28.0, 42.0, 56.0})
    centres.insert(centres.end(), {{at.x + half, at.y},
                                   {at.x - half, at.y},
                                   {at.x, at.y - away},
                                   {at.x, at.y + away},
                                   {at.x + half, at.y - away},
                                   {at.x - half, at.y - away},
                                   {at.x + half, at.y + away},
                                   {at.x - half, at.y + away}});
  return centres;
}

LabelPlacer::Point LabelPlacer::nearest_of(std::string_view text, Point centre, Point to) {
  const Area label = area(text, centre);
  return {std::clamp(to.x, label.left, label.right), std::clamp(to.y, label.top, label.bottom)};
}

}  // namespace hyrax
