#include "tools/report/label_placer.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace hyrax {
namespace {

// Centres of a label beside a point, the nearest first.
std::vector<SvgPoint> centres_around(SvgPoint at, std::string_view text) {
  const double half = LabelPlacer::width(text) / 2 + 6;
  std::vector<SvgPoint> centres;
  constexpr double kNearest = 14.0;
  for (const double away : {kNearest, 28.0, 42.0, 56.0, 70.0, 84.0, 98.0})
    centres.insert(centres.end(), {{at.x + half + away - kNearest, at.y},
                                   {at.x - half - away + kNearest, at.y},
                                   {at.x, at.y - away},
                                   {at.x, at.y + away},
                                   {at.x + half, at.y - away},
                                   {at.x - half, at.y - away},
                                   {at.x + half, at.y + away},
                                   {at.x - half, at.y + away}});
  return centres;
}

}  // namespace

void LabelPlacer::avoid(SvgPoint from, SvgPoint to) {
  constexpr double kPartLength = 3.0;
  constexpr double kPartsMax = 1000.0;  // Of a line that leads far outside.
  if (!std::isfinite(from.x + from.y + to.x + to.y)) return;
  const double parts =
      std::clamp(std::ceil(std::hypot(to.x - from.x, to.y - from.y) / kPartLength), 1.0, kPartsMax);
  for (double part = 0.0; part <= parts; part += 1.0)
    avoided_.push_back({from.x + (to.x - from.x) * part / parts, from.y + (to.y - from.y) * part / parts});
}

void LabelPlacer::avoid_line(const std::vector<SvgPoint>& points) {
  for (std::size_t index = 1; index < points.size(); ++index) avoid(points[index - 1], points[index]);
}

void LabelPlacer::avoid_outline(const Box& box) {
  avoid_line({{box.left, box.top},
              {box.right, box.top},
              {box.right, box.bottom},
              {box.left, box.bottom},
              {box.left, box.top}});
}

Box LabelPlacer::area(std::string_view text, SvgPoint centre) {
  constexpr double kHalfHeight = 7.5;
  const double half = width(text) / 2;
  return {centre.x - half, centre.y - kHalfHeight, centre.x + half, centre.y + kHalfHeight};
}

double LabelPlacer::covered_by(SvgPoint from, SvgPoint to) const {
  constexpr double kNear = 5.0;
  const double dx = to.x - from.x, dy = to.y - from.y, square = std::max(dx * dx + dy * dy, 1e-9);
  return static_cast<double>(std::ranges::count_if(avoided_, [&](const SvgPoint& point) {
    const double part = std::clamp(((point.x - from.x) * dx + (point.y - from.y) * dy) / square, 0.0, 1.0);
    return std::hypot(point.x - from.x - part * dx, point.y - from.y - part * dy) < kNear;
  }));
}

SvgPoint LabelPlacer::moved_inside(const Box& label) const {
  const auto [x, y] = label.centre();
  const double dx = std::max(inside_.left - label.left, 0.0) - std::max(label.right - inside_.right, 0.0);
  const double dy = std::max(inside_.top - label.top, 0.0) - std::max(label.bottom - inside_.bottom, 0.0);
  return {x + dx, y + dy};
}

double LabelPlacer::cost(const Box& label) const {
  double cost = 0.0;
  for (const Box& other : labels_)
    if (label.left < other.right && other.left < label.right && label.top < other.bottom &&
        other.top < label.bottom)
      cost += kOther;
  for (const SvgPoint& point : avoided_)
    if (point.x > label.left && point.x < label.right && point.y > label.top && point.y < label.bottom)
      cost += 1.0;
  return cost;
}

SvgPoint LabelPlacer::place(std::string_view text, const std::vector<SvgPoint>& centres) {
  assert(!centres.empty());
  double least = HUGE_VAL;
  SvgPoint best;
  for (const SvgPoint& centre : centres) {
    const SvgPoint at = moved_inside(area(text, centre));
    // One that had to be moved is not where it was wanted.
    const double its_cost = cost(area(text, at)) + 10.0 * std::hypot(at.x - centre.x, at.y - centre.y);
    if (its_cost >= least) continue;
    least = its_cost;
    best = at;
  }
  labels_.push_back(area(text, best));
  return best;
}

void LabelPlacer::draw_beside(Svg& svg, SvgPoint at, std::string_view text, Tone tone, bool is_optional) {
  constexpr double kBeside = 10.0;
  const std::vector<SvgPoint> centres = centres_around(at, text);
  const auto covers_another = [&](SvgPoint centre) {
    return cost(area(text, moved_inside(area(text, centre)))) >= kOther;
  };
  if (is_optional && std::ranges::all_of(centres, covers_another)) return;
  const SvgPoint centre = place(text, centres);
  const Box label = area(text, centre);
  const SvgPoint edge{std::clamp(at.x, label.left, label.right), std::clamp(at.y, label.top, label.bottom)};
  avoid(at, edge);
  if (std::hypot(edge.x - at.x, edge.y - at.y) > kBeside)
    svg.line({at, edge}, {colour_of(Tone::quiet), 0.75});
  svg.text(centre, text, lettering(tone));
}

}  // namespace hyrax
