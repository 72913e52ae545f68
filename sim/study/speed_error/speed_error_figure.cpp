#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "sim/result/number_text.h"
#include "sim/study/speed_error/speed_error.h"

namespace hyrax {
namespace {

// In the order of frame_methods().
constexpr std::array<Look, 10> kLooks = {
    {{.tone = Tone::vermilion, .width_px = 4.0},
     {.tone = Tone::vermilion, .width_px = 2.0, .dash = Dash::short_dashes},
     {.tone = Tone::orange},
     {.tone = Tone::purple},
     {.tone = Tone::sky_blue},
     {.tone = Tone::blue},
     {.tone = Tone::green, .width_px = 3.0},
     {.tone = Tone::blue, .width_px = 2.0, .dash = Dash::short_dashes},
     {.tone = Tone::green, .width_px = 2.0, .dash = Dash::short_dashes},
     {.tone = Tone::ink, .width_px = 2.0, .dash = Dash::long_dashes}}};
constexpr Look kAdaptiveLook{
    .form = Form::line_and_points, .tone = Tone::faint, .width_px = 1.5, .marker_size = 0.25};
constexpr Look kEndOnlyLook{.form = Form::line_and_points,
                            .tone = Tone::faint,
                            .width_px = 1.25,
                            .dash = Dash::short_dashes,
                            .marker_size = 0.25};
constexpr Look kFrontLook{
    .form = Form::points, .tone = Tone::ink, .marker = Marker::square, .marker_size = 1.5};
// What costs more than so many times the paper's step at 60 Hz, nobody would use: a note names it.
constexpr double kUsable = 1000.0;
constexpr std::array<int, 5> kRatesNamed_hz = {15, 60, 240, 960, 3840};
// The rate for which the laws are defined, on every method's line.
constexpr double kRinged_hz = 60.0;
constexpr Look kRingLook{.form = Form::points, .tone = Tone::ink, .marker = Marker::ring, .marker_size = 1.2};

// The points that one line joins: a method at all rates, or a family at all tolerances.
struct Curve {
  std::size_t method = 0;  // The first of them.
  std::vector<const WorkPoint*> points;
};

std::vector<Curve> curves_of(const SpeedError& study, std::size_t problem) {
  std::vector<Curve> curves;
  for (const WorkPoint& point : study.points) {
    if (point.problem != problem) continue;
    const std::string& family = study.methods[point.method].family;
    const auto is_of_it = [&](const Curve& curve) {
      if (family.empty()) return curve.method == point.method;
      return study.methods[curve.method].family == family && curve.points.front()->rate_hz == point.rate_hz;
    };
    auto curve = std::find_if(curves.begin(), curves.end(), is_of_it);
    if (curve == curves.end()) curve = curves.insert(curves.end(), {point.method, {}});
    curve->points.push_back(&point);
  }
  return curves;
}

// The two plots of one problem, and their legend.
class Diagram {
 public:
  Diagram(const SpeedError& study, std::size_t problem) : study_(study), curves_(curves_of(study, problem)) {
    for (const WorkPoint& point : study.points)
      if (point.problem == problem && point.method == 0 && point.rate_hz == kRowRate_hz &&
          point.cost.time_ns.median > 0.0)
        usable_ns_ = kUsable * point.cost.time_ns.median;
    for (const Curve& curve : curves_) over_cost_.push_back(over_cost(curve));
  }

  [[nodiscard]] Plot cost_plot() const {
    Plot plot{
        .x = {.label = "cost, ns per simulated second of 60 rows, without set-up", .is_logarithmic = true},
        .y = error_axis()};
    if (!study_.probe.is_steady()) {
      plot.when_empty = unsteady_text(study_.probe);
      return plot;
    }
    Series front{.name = "Pareto front", .look = kFrontLook}, ring = ring_series();
    for (const Curve* const curve : in_drawing_order(over_cost_)) {
      if (curve->points.empty()) continue;
      const MethodKind& method = study_.methods[curve->method];
      if (method.is_reference()) {
        if (curve->points.front()->cost.is_measured())
          plot.marks.push_back({.at = curve->points.front()->cost.time_ns.median,
                                .text = "the reference: " + method.label,
                                .tone = Tone::quiet});
        continue;
      }
      Series series = series_of(*curve);
      if (curve->points.size() == 1) series.look.marker_size = 0.7;
      for (const WorkPoint* const point : curve->points) {
        series.x.push_back(point->cost.time_ns.median);
        series.x_low.push_back(point->cost.time_ns.low);
        series.x_high.push_back(point->cost.time_ns.high);
        if (!point->cost.is_measured()) continue;
        if (!is_adaptive(*curve)) add_ringed(ring, *point, point->cost.time_ns.median);
        if (curve->method == 0 && has_text(*point))
          plot.texts.push_back({point->cost.time_ns.median, point->errors.position_px, rate_text(*point)});
        if (!point->is_pareto) continue;
        front.x.push_back(point->cost.time_ns.median);
        front.y.push_back(point->errors.position_px);
      }
      plot.series.push_back(std::move(series));
    }
    plot.series.push_back(std::move(front));
    plot.series.push_back(std::move(ring));
    const std::vector<PointText> names = names_over_cost();
    plot.texts.insert(plot.texts.end(), names.begin(), names.end());
    return plot;
  }

  [[nodiscard]] Plot dt_plot() const {
    Plot plot{.x = {.label = "dt, s", .is_logarithmic = true},
              .y = error_axis(),
              .marks = {{.at = 1.0 / kRinged_hz, .text = "laws defined at 60 Hz", .tone = Tone::quiet}}};
    double longest_s = 0.0;
    Series ring = ring_series();
    for (const int rate_hz : kRatesNamed_hz)
      plot.x.ticks.push_back({1.0 / rate_hz, fmt::format("1/{}", rate_hz)});
    for (const Curve* const curve : in_drawing_order(curves_)) {
      if (is_adaptive(*curve) || study_.methods[curve->method].is_reference()) continue;
      Series series = series_of(*curve);
      for (const WorkPoint* const point : curve->points) {
        series.x.push_back(1.0 / point->rate_hz);
        longest_s = std::max(longest_s, series.x.back());
        add_ringed(ring, *point, series.x.back());
      }
      plot.texts.push_back(name_beside(*curve, series));
      plot.series.push_back(std::move(series));
    }
    plot.series.push_back(std::move(ring));
    constexpr double kRoomForNames = 250.0;
    plot.x.high = longest_s * kRoomForNames;
    return plot;
  }

  [[nodiscard]] std::vector<LegendEntry> legend() const {
    std::vector<LegendEntry> entries = {{"60 Hz", kRingLook}};
    bool has_adaptive = false, has_end_only = false;
    for (const Curve& curve : curves_)
      if (is_adaptive(curve)) (is_end_only(curve) ? has_end_only : has_adaptive) = true;
    if (!study_.probe.is_steady()) return entries;
    if (has_adaptive) entries.push_back({"GSL's steppers, over tolerances", kAdaptiveLook});
    if (has_end_only) entries.push_back({"the same without rows: their end only", kEndOnlyLook});
    entries.push_back({"Pareto front: none as near is cheaper in every process", kFrontLook});
    return entries;
  }

  /// What the cost plot leaves out; empty: nothing.
  [[nodiscard]] std::string left_out() const {
    std::vector<std::string> names;
    double most_ns = 0.0;
    for (const Curve& curve : curves_)
      for (const WorkPoint* const point : curve.points) {
        if (!(point->cost.time_ns.median > usable_ns_)) continue;
        most_ns = std::max(most_ns, point->cost.time_ns.median);
        if (std::ranges::find(names, short_name(curve)) == names.end()) names.push_back(short_name(curve));
      }
    if (names.empty()) return "";
    return fmt::format(
        "Not drawn: what costs more than {} times the paper's step at 60 Hz, up to {} ms: of {}.",
        rounded(kUsable), rounded(most_ns / 1e6, 2), fmt::join(names, ", "));
  }

 private:
  [[nodiscard]] bool is_adaptive(const Curve& curve) const {
    return study_.methods[curve.method].is_adaptive();
  }

  [[nodiscard]] std::string short_name(const Curve& curve) const {
    const MethodKind& method = study_.methods[curve.method];
    return method.family.empty() ? method.label : method.family.substr(method.family.rfind(' ') + 1);
  }

  [[nodiscard]] bool is_end_only(const Curve& curve) const {
    return is_adaptive(curve) && curve.points.front()->rate_hz < kRowRate_hz;
  }

  // Whether all are the same to twice the error and the cost: the tolerance does nothing.
  [[nodiscard]] static bool are_alike(const std::vector<const WorkPoint*>& points) {
    const auto is_within_twice = [&points](const auto& value) {
      const auto [low, high] = std::ranges::minmax(points, {}, value);
      return value(high) <= 2.0 * value(low);
    };
    return !points.empty() &&
           is_within_twice([](const WorkPoint* point) { return point->cost.time_ns.median; }) &&
           is_within_twice([](const WorkPoint* point) {
             return std::max(point->errors.position_px, rounding_px(point->errors));
           });
  }

  // What of a curve is drawn over cost: with all rows, what is usable; of a family of which the tolerance
  // does nothing the cheapest.
  [[nodiscard]] Curve over_cost(const Curve& curve) const {
    Curve shown{curve.method, {}};
    for (const WorkPoint* const point : curve.points)
      if ((is_adaptive(curve) || point->rate_hz >= kRowRate_hz) && !(point->cost.time_ns.median > usable_ns_))
        shown.points.push_back(point);
    if (is_adaptive(curve) && are_alike(shown.points))
      shown.points = {*std::ranges::min_element(
          shown.points, {}, [](const WorkPoint* point) { return point->cost.time_ns.median; })};
    return shown;
  }

  [[nodiscard]] static bool has_text(const WorkPoint& point) {
    return std::ranges::find(kRatesNamed_hz, static_cast<int>(point.rate_hz)) != kRatesNamed_hz.end();
  }

  // Grey first, the paper's step last: the later is drawn over the earlier.
  [[nodiscard]] std::vector<const Curve*> in_drawing_order(const std::vector<Curve>& curves) const {
    std::vector<const Curve*> order;
    for (const Curve& curve : curves) order.insert(order.begin(), &curve);
    std::stable_partition(order.begin(), order.end(),
                          [&](const Curve* curve) { return is_adaptive(*curve); });
    return order;
  }

  // A curve's name, look and errors; a gap where the method failed.
  [[nodiscard]] Series series_of(const Curve& curve) const {
    const MethodKind& method = study_.methods[curve.method];
    Series series{.name = method.family.empty() ? method.label : method.family, .look = kAdaptiveLook};
    if (is_end_only(curve)) {
      series.name += ", end only";
      series.look = kEndOnlyLook;
    } else if (!method.is_adaptive() && curve.method < kLooks.size()) {
      series.look = kLooks[curve.method];
      series.look.form = Form::line_and_points;
      series.look.marker_size = 0.5;
    }
    for (const WorkPoint* const point : curve.points) {
      series.y.push_back(point->errors.is_failed ? kNotGiven : point->errors.position_px);
      series.point_names.push_back(method.is_adaptive() ? study_.methods[point->method].label
                                                        : rate_text(*point));
    }
    return series;
  }

  static Series ring_series() { return {.name = "60 Hz", .look = kRingLook}; }

  static void add_ringed(Series& ring, const WorkPoint& point, double x) {
    if (point.rate_hz != kRinged_hz || point.errors.is_failed) return;
    ring.x.push_back(x);
    ring.y.push_back(point.errors.position_px);
  }

  static std::string rate_text(const WorkPoint& point) { return rounded(point.rate_hz) + " Hz"; }

  // A method's name and order, at the end of its line where frames are longest.
  [[nodiscard]] PointText name_beside(const Curve& curve, const Series& series) const {
    std::size_t last = 0;
    for (std::size_t row = 0; row < series.x.size(); ++row)
      if (!std::isnan(series.y[row]) && series.x[row] >= series.x[last]) last = row;
    return {series.x[last], series.y[last], series.name + ": " + order_text(curve), series.look.tone};
  }

  // No error at all is drawn below the least error, or low enough that large errors do not lie flat.
  [[nodiscard]] Axis error_axis() const {
    constexpr double kLeastAmongLarge_px = 1e-2;
    constexpr double kRounding_px = 1e-8;
    double least_px = kLeastAmongLarge_px;
    for (const Curve& curve : curves_)
      for (const WorkPoint* const point : curve.points)
        if (point->errors.position_px > 0.0) least_px = std::min(least_px, point->errors.position_px);
    return {.label = "distance, px (largest over the run)",
            .is_logarithmic = true,
            .zero_at = std::pow(10.0, std::floor(std::log10(least_px)) - 2.0),
            .strip_below = kRounding_px,
            .strip_name = "rounding"};
  }

  // The names of the methods: of lines where they end at the largest cost, of GSL's steppers with rows at the
  // most accurate point, without rows at the cheapest; and what the line of zeros is.
  [[nodiscard]] std::vector<PointText> names_over_cost() const {
    std::vector<PointText> texts, optional;  // These are beside the same looks over dt, or without dashes.
    const WorkPoint* zero = nullptr;
    for (const Curve& curve : over_cost_) {
      if (study_.methods[curve.method].is_reference()) continue;
      const WorkPoint *cheapest = nullptr, *last = nullptr;
      for (const WorkPoint* const point : curve.points) {
        if (point->errors.is_failed || !point->cost.is_measured()) continue;
        if (cheapest == nullptr || point->cost.time_ns.median < cheapest->cost.time_ns.median)
          cheapest = point;
        last = point;
        if (is_ranked(study_, *point) && point->errors.position_px == 0.0 &&
            (!zero || zero->cost.time_ns.median < point->cost.time_ns.median))
          zero = point;
      }
      if (last == nullptr) continue;
      const WorkPoint& at = is_end_only(curve) ? *cheapest : *last;
      const bool is_named_elsewhere = !is_adaptive(curve) || is_end_only(curve);
      (is_named_elsewhere ? optional : texts)
          .push_back({at.cost.time_ns.median, at.errors.position_px, short_name(curve),
                      is_adaptive(curve) ? Tone::quiet : series_of(curve).look.tone, is_named_elsewhere});
    }
    if (zero != nullptr) texts.push_back({zero->cost.time_ns.median, 0.0, "no error at all"});
    texts.insert(texts.end(), optional.begin(), optional.end());
    return texts;
  }

  [[nodiscard]] std::string order_text(const Curve& curve) const {
    const bool is_exact = std::all_of(curve.points.begin(), curve.points.end(), [](const WorkPoint* point) {
      return point->errors.position_px <= rounding_px(point->errors);
    });
    if (is_exact) return "exact";
    for (const OrderFit& fit : study_.orders)
      if (fit.problem == curve.points.front()->problem && fit.method == curve.method)
        return fmt::format("order {}{:.2f}", fit.order < 0.0 ? "−" : "", std::fabs(fit.order));
    return "no order";
  }

  const SpeedError& study_;
  std::vector<Curve> curves_;
  std::vector<Curve> over_cost_ = {};
  double usable_ns_ = std::numeric_limits<double>::infinity();
};

}  // namespace

Figure speed_error_figure(const SpeedError& study, std::size_t problem, const std::string& machine) {
  assert(problem < study.problems.size());
  const Problem& played = study.problems[problem];
  const Diagram diagram(study, problem);
  Figure figure{
      .suffix = "-" + played.name,
      .title = "Speed against error: " + played.label + (played.remark.empty() ? "" : ", " + played.remark),
      .subtitle = "Distance from the fixed laws (drag as at 60 Hz, exact impacts)",
      .body = std::vector{diagram.cost_plot(), diagram.dt_plot()},
      .legend = diagram.legend()};
  if (study.probe.is_steady())
    figure.subtitle += fmt::format("; bars: 95 % interval of the median of {} processes on {}",
                                   study.cost.processes, machine);
  if (problem == 0) figure.remarks = convergence_sentences(study);  // They are about its free flight.
  if (std::string text = diagram.left_out(); !text.empty()) figure.remarks.push_back(std::move(text));
  return figure;
}

std::optional<Figure> bands_figure(const SpeedError& study, std::size_t problem) {
  constexpr double kRounding_px = 0.1;  // All below is drawn as 0.
  Plot plot{.x = {.label = "largest distance from the exact fling, px",
                  .is_logarithmic = true,
                  .zero_at = kRounding_px,
                  .zero_text = "≤ 0.1"}};
  Series series{.name = "median", .look = {.form = Form::points, .tone = Tone::blue, .marker_size = 1.0}};
  Share flings;
  for (const MethodBands& bands : study.bands) {
    if (bands.problem != problem || bands.rate_hz != kRowRate_hz) continue;
    flings = bands.nearer;
    const auto y = static_cast<double>(plot.y.categories.size());
    plot.y.categories.push_back(study.methods[bands.method].label);
    series.x.push_back(bands.position_px.median);
    series.x_low.push_back(bands.position_px.low);
    series.x_high.push_back(bands.position_px.high);
    series.y.push_back(y);
    if (bands.method != 0)
      plot.texts.push_back(
          {bands.position_px.high, y, fmt::format("ends nearer in {} of {}", flings.count, flings.of)});
    constexpr double kRoomForText = 30.0;
    plot.x.high =
        std::max(std::isnan(plot.x.high) ? 0.0 : plot.x.high, kRoomForText * bands.position_px.high);
  }
  if (series.x.empty()) return std::nullopt;
  plot.series = {std::move(series)};
  return Figure{
      .suffix = "-" + study.problems[problem].name + "-starts",
      .title = fmt::format("{} flings at 60 Hz: like {}", flings.of, study.problems[problem].label),
      .subtitle = fmt::format("Starts within {:g} px, speeds within {:g} %, seed {}; dot: median, bar: 10 "
                              "to 90 %; nearer: than by the paper's step",
                              kBandStart_px, 100.0 * kBandSpeed_rel, kBandSeed),
      .body = std::vector{std::move(plot)}};
}

std::optional<Figure> energies_figure(const SpeedError& study, std::size_t problem) {
  const auto bands = std::ranges::find_if(study.bands, [problem](const MethodBands& each) {
    return each.problem == problem && each.method == 0 && each.rate_hz == kRowRate_hz;
  });
  if (bands == study.bands.end() || bands->energies.empty()) return std::nullopt;
  Plot plot{.x = {.label = "flings", .low = 0.0}};
  Series series{.name = "flings", .look = {.form = Form::bars, .tone = Tone::blue}};
  for (const ErrorBin& bin : bands->energies) {
    const auto y = static_cast<double>(plot.y.categories.size());
    plot.y.categories.push_back(rounded(100.0 * bin.low, 3) + " to " + rounded(100.0 * bin.high, 3) + " %");
    series.x.push_back(static_cast<double>(bin.flings));
    series.y.push_back(y);
    plot.texts.push_back({series.x.back(), y, std::to_string(bin.flings)});
  }
  plot.series = {std::move(series)};
  return Figure{
      .suffix = "-" + study.problems[problem].name + "-energy",
      .title = fmt::format("The paper's step at 60 Hz is off by {} % in energy",
                           rounded(100.0 * bands->energy_rel.median, 2)),
      .subtitle = fmt::format(
          "Median of {} flings like {}: the largest difference from the exact fling while both have met "
          "each wall equally often, of the largest kinetic energy",
          bands->energy_rel.samples, study.problems[problem].label),
      .body = std::vector{std::move(plot)}};
}

std::vector<std::string> convergence_sentences(const SpeedError& study) {
  const auto at_60 = std::ranges::find(study.paper, 60.0, &PaperErrors::rate_hz);
  if (at_60 == study.paper.end() || !(study.laws.air_drag < 1.0)) return {};
  const PaperErrors& last = study.paper.back();
  return {
      fmt::format("Drag per frame keeps the paper's step from converging: each frame takes {:.3g} % of the "
                  "speed, however short it is.",
                  100.0 * (1.0 - study.laws.air_drag)),
      fmt::format("Over {}, its error is {} px at 60 Hz and {} px at {:.0f} Hz.",
                  study.problems.front().label, rounded(at_60->model_px, 3), rounded(last.model_px, 3),
                  last.rate_hz)};
}

}  // namespace hyrax
