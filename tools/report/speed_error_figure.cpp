#include "tools/report/speed_error_figure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "tools/report/figure_style.h"
#include "tools/report/plot_frame.h"

namespace hyrax {
namespace {

constexpr Canvas kCanvas{1180, 760};
constexpr double kTop = 108;  // Of both plots on the canvas, in px of the SVG, as all that follow.
constexpr double kBottom = 530;
constexpr double kLeft = 76;
constexpr double kLeftEnd = 640;
constexpr double kRight = 732;
constexpr double kRightEnd = 1150;
constexpr double kKeyTop = 600;
constexpr double kKeyLine = 24;
// The smallest error of a picture of large ones: so that these do not lie flat.
constexpr double kNothingAmongLarge_px = 1e-2;

struct LineStyle {
  std::string_view colour;
  double width;
  std::string_view dashes;
};

// In the order of frame_methods().
constexpr std::array<LineStyle, 8> kStyles = {{{style::kVermilion, 4, "solid"},
                                               {style::kVermilion, 2, "(4,4)"},
                                               {style::kOrange, 2.5, "solid"},
                                               {style::kPurple, 2.5, "solid"},
                                               {style::kSkyBlue, 2.5, "solid"},
                                               {style::kBlue, 2.5, "solid"},
                                               {style::kGreen, 3, "solid"},
                                               {style::kInk, 2, "(8,4)"}}};

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
      return curve.method == point.method ||
             (!family.empty() && study.methods[curve.method].family == family);
    };
    auto curve = std::find_if(curves.begin(), curves.end(), is_of_it);
    if (curve == curves.end()) curve = curves.insert(curves.end(), {point.method, {}});
    curve->points.push_back(&point);
  }
  return curves;
}

// Below all errors, and half way between two tics.
double line_of_nothing_px(const std::vector<Curve>& curves) {
  double least_px = kNothingAmongLarge_px;
  for (const Curve& curve : curves)
    for (const WorkPoint* point : curve.points)
      if (point->errors.position_px > 0.0) least_px = std::min(least_px, point->errors.position_px);
  const int exponent = static_cast<int>(std::floor(std::log10(least_px))) - 1;
  return std::pow(10.0, exponent % 2 == 0 ? exponent - 1 : exponent);
}

// Every error of the curve is rounding.
bool is_exact(const Curve& curve) {
  return std::all_of(curve.points.begin(), curve.points.end(), [](const WorkPoint* point) {
    return point->errors.position_px <= rounding_px(point->errors);
  });
}

bool is_adaptive(const SpeedError& study, const Curve& curve) {
  return study.methods[curve.method].tolerance > 0.0;
}

std::string block(const std::string& name, const Curve& curve, double nothing_px) {
  std::string lines;
  for (const WorkPoint* point : curve.points) {
    if (point->errors.is_failed)
      lines += "NaN NaN NaN\n";
    else
      lines += fmt::format("{:.6g} {:.6g} {:.6g}\n", point->cost.median_ns,
                           std::max(point->errors.position_px, nothing_px), 1.0 / point->rate_hz);
  }
  return fmt::format("${} << EOD\n{}EOD\n", name, lines);
}

std::string pareto_block(const std::vector<Curve>& curves, double nothing_px) {
  std::string lines;
  for (const Curve& curve : curves)
    for (const WorkPoint* point : curve.points)
      if (point->is_pareto)
        lines += fmt::format("{:.6g} {:.6g}\n", point->cost.median_ns,
                             std::max(point->errors.position_px, nothing_px));
  return fmt::format("$front << EOD\n{}EOD\n", lines.empty() ? "NaN NaN\n" : lines);
}

// What the key says of a method's order on this problem.
std::string order_words(const SpeedError& study, const Curve& curve) {
  if (study.methods[curve.method].name == "event-driven") return "the truth itself";
  if (is_exact(curve)) return "exact but for rounding";
  for (const OrderFit& fit : study.orders)
    if (fit.problem == curve.points.front()->problem && fit.method == curve.method) {
      if (fit.order < 0.0) return fmt::format("order −{:.2f}, grows", -fit.order);
      return fmt::format("order {:.2f}", fit.order);
    }
  return "too few points for an order";
}

std::string log_axis(char axis, double low, double high, int every) {
  std::string tics;
  for (int exponent = static_cast<int>(std::floor(std::log10(low))); exponent <= std::log10(high) + 1e-9;
       ++exponent)
    if ((exponent % every + every) % every == 0)
      tics += fmt::format("{}'{}' 1e{}", tics.empty() ? "" : ", ", power_of_ten(exponent), exponent);
  return fmt::format("set logscale {0}\nset {0}range [{1:.6g}:{2:.6g}]\nset {0}tics ({3})\n", axis, low, high,
                     tics);
}

std::string margins(double left, double right) {
  return fmt::format(
      "set lmargin at screen {:.6f}\nset rmargin at screen {:.6f}\n"
      "set tmargin at screen {:.6f}\nset bmargin at screen {:.6f}\n",
      left / kCanvas.width, right / kCanvas.width, 1 - kTop / kCanvas.height, 1 - kBottom / kCanvas.height);
}

struct Range {
  double low = HUGE_VAL;
  double high = 0.0;
  void see(double value) {
    if (!(value > 0.0)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

class Diagram {
 public:
  Diagram(const SpeedError& study, std::size_t problem, const std::string& machine)
      : study_(study), curves_(curves_of(study, problem)), nothing_px_(line_of_nothing_px(curves_)) {
    const Problem& played = study.problems[problem];
    std::string words = "Speed against error: " + played.words;
    if (!played.remark.empty()) words += ", " + played.remark;
    script_ = figure_head(kCanvas, words,
                          fmt::format("Distance from the fixed laws (drag as at 60 Hz, exact impacts); {} "
                                      "repetitions on {}",
                                      study.repetitions, machine));
    for (std::size_t curve = 0; curve < curves_.size(); ++curve)
      script_ += block(fmt::format("curve{}", curve), curves_[curve], nothing_px_);
    script_ += pareto_block(curves_, nothing_px_);
    draw_key();
    // It speaks of the free flight that the first problem is.
    if (problem == 0) write_sentence();
    script_ +=
        "set multiplot\nset xtics out font ',12' offset 0,0.3\nset ytics out font ',12' offset 0.5,0\n";
    script_ += fmt::format("set grid back lt 1 lw 1 lc rgb '{}'\n", style::kHairline);
    draw_against_cost();
    draw_against_dt();
    script_ += "unset multiplot\n";
  }
  [[nodiscard]] std::string take() { return std::move(script_); }

 private:
  [[nodiscard]] LineStyle style_of(const Curve& curve) const {
    if (is_adaptive(study_, curve) || curve.method >= kStyles.size()) return {style::kFaintInk, 1.5, "solid"};
    return kStyles[curve.method];
  }

  [[nodiscard]] const std::string& name_of(const Curve& curve) const {
    const MethodKind& method = study_.methods[curve.method];
    return method.family.empty() ? method.words : method.family;
  }

  [[nodiscard]] std::string y_axis() const {
    Range range;
    for (const Curve& curve : curves_)
      for (const WorkPoint* point : curve.points)
        if (!point->errors.is_failed) range.see(std::max(point->errors.position_px, nothing_px_));
    std::string axis = log_axis('y', range.low * 0.5, range.high * 3.0, 2);
    // The axis has no place for zero: its line is named, and is no power of ten.
    if (has_nothing()) axis += fmt::format("set ytics add ('0' {:.6g})\n", nothing_px_);
    return axis;
  }

  [[nodiscard]] bool has_nothing() const {
    for (const Curve& curve : curves_)
      for (const WorkPoint* point : curve.points)
        if (!point->errors.is_failed && point->errors.position_px <= nothing_px_) return true;
    return false;
  }

  // From the lower end of the axis of errors to its upper one.
  [[nodiscard]] double error_decades() const {
    Range range;
    for (const Curve& curve : curves_)
      for (const WorkPoint* point : curve.points)
        if (!point->errors.is_failed) range.see(std::max(point->errors.position_px, nothing_px_));
    return std::log10(range.high * 3.0 / (range.low * 0.5));
  }

  void name_axes(double left, double right, std::string_view x_words) {
    script_ +=
        fmt::format("set label 20 'distance, px (largest over the run)' at {} left font ',12' tc rgb '{}'\n",
                    screen(kCanvas, left - 46, kTop - 18), style::kQuietInk);
    script_ += fmt::format("set label 21 {} at {} right font ',12' tc rgb '{}'\n", quoted(x_words),
                           screen(kCanvas, right, kBottom + 38), style::kQuietInk);
    script_ += fmt::format(
        "set object 2 rectangle from graph 0,0 to graph 1,1 behind fs solid 1 noborder fc rgb '{}'\n",
        style::kPaper);
  }

  void plot(std::string_view columns, bool with_adaptive, bool with_front) {
    std::string command;
    // Grey first, so that colours lie above; the paper's step last.
    for (const bool adaptive : {true, false})
      for (std::size_t index = curves_.size(); index-- > 0;) {
        const Curve& curve = curves_[index];
        if (is_adaptive(study_, curve) != adaptive || (adaptive && !with_adaptive)) continue;
        const LineStyle look = style_of(curve);
        command +=
            fmt::format("{} $curve{} using {} title {} with linespoints pt 7 ps {} lw {} dt {} lc rgb '{}'",
                        command.empty() ? "plot" : ",", index, columns, quoted(name_of(curve)),
                        adaptive ? 0.25 : 0.5, look.width, look.dashes, look.colour);
      }
    if (with_front)
      command += fmt::format(
          ", $front using 1:2 title 'Pareto front' with points pt 6 ps 1.4 lw 1.5 lc rgb '{}'", style::kInk);
    script_ += command + "\n";
  }

  void draw_against_cost() {
    Range range;
    for (const Curve& curve : curves_)
      for (const WorkPoint* point : curve.points)
        if (!point->errors.is_failed) range.see(point->cost.median_ns);
    script_ += margins(kLeft, kLeftEnd) + y_axis() + log_axis('x', range.low * 0.7, range.high * 1.5, 1);
    name_axes(kLeft, kLeftEnd, "cost, ns per simulated second");
    name_steppers(range.low * 0.7, range.high * 1.5);
    if (has_nothing())
      script_ += fmt::format(
          "set label 22 'no error at all' at graph 0.99, first {:.3g} right font ',11' tc rgb '{}'\n",
          4.0 * nothing_px_, style::kQuietInk);
    plot("1:2", true, true);
    // What was drawn once need not be drawn again over it.
    script_ += "unset label\nunset object\nunset arrow\n";
  }

  void draw_against_dt() {
    Range range;
    for (const Curve& curve : curves_)
      for (const WorkPoint* point : curve.points)
        if (!is_adaptive(study_, curve)) range.see(1.0 / point->rate_hz);
    script_ += margins(kRight, kRightEnd) + y_axis() + log_axis('x', range.low * 0.8, range.high * 1.25, 1);
    std::string tics;
    for (const int rate_hz : {15, 60, 240, 960, 3840})
      tics += fmt::format("{}'1/{}' {:.8g}", tics.empty() ? "" : ", ", rate_hz, 1.0 / rate_hz);
    script_ += fmt::format("set xtics ({})\n", tics);
    name_axes(kRight, kRightEnd, "dt, s");
    script_ += fmt::format(
        "set arrow 40 from first {0:.8g}, graph 0 to first {0:.8g}, graph 1 nohead back lw 1.5 dt (6,4) lc "
        "rgb '{1}'\n"
        "set label 40 'laws defined at 60 Hz' at first {0:.8g}, graph 1.03 center font ',11' tc rgb '{1}'\n",
        1.0 / 60.0, style::kQuietInk);
    plot("3:2", false, false);
  }

  // Each of GSL's steppers by name, at its most exact point; where names would meet, the later one goes up.
  void name_steppers(double low_ns, double high_ns) {
    const double decades_wide = std::log10(high_ns / low_ns) / (kLeftEnd - kLeft);
    const double decades_high = error_decades() / (kBottom - kTop);
    std::vector<std::pair<double, double>> named;  // In px from the origin of the axes.
    int label = 30;
    for (const Curve& curve : curves_) {
      if (!is_adaptive(study_, curve)) continue;
      const std::string& family = study_.methods[curve.method].family;
      const std::string name = family.substr(family.rfind(' ') + 1);
      const WorkPoint* last = nullptr;
      for (const WorkPoint* point : curve.points)
        if (!point->errors.is_failed) last = point;
      if (last == nullptr) continue;
      const double x = std::log10(last->cost.median_ns) / decades_wide;
      double y = std::log10(std::max(last->errors.position_px, nothing_px_)) / decades_high;
      const auto meets = [&](const std::pair<double, double>& other) {
        return std::fabs(other.first - x) < 50.0 && std::fabs(other.second - y) < 12.0;
      };
      while (std::any_of(named.begin(), named.end(), meets)) y += 3.0;
      named.emplace_back(x, y);
      script_ += fmt::format(
          "set label {} {} at first {:.6g}, first {:.6g} left offset 0.8,0 font ',11' tc rgb '{}'\n", label++,
          quoted(name), last->cost.median_ns, std::pow(10.0, y * decades_high), style::kQuietInk);
    }
  }

  // Three columns of lines with their words and orders.
  void draw_key() {
    std::size_t place = 0;
    bool has_adaptive = false;
    const auto add = [&](const LineStyle& look, const std::string& words, const std::string& order) {
      const double x = kLeft - 40 + 375.0 * static_cast<double>(place / 4);
      const double y = kKeyTop + kKeyLine * static_cast<double>(place % 4);
      ++place;
      script_ +=
          fmt::format("set arrow from {} to {} nohead lw {} dt {} lc rgb '{}'\n", screen(kCanvas, x, y),
                      screen(kCanvas, x + 30, y), look.width, look.dashes, look.colour);
      script_ += fmt::format("set label {} at {} left font ',13' tc rgb '{}'\n",
                             quoted(words + (order.empty() ? "" : ": " + order)), screen(kCanvas, x + 38, y),
                             style::kInk);
    };
    for (const Curve& curve : curves_) {
      if (is_adaptive(study_, curve))
        has_adaptive = true;
      else
        add(style_of(curve), study_.methods[curve.method].words, order_words(study_, curve));
    }
    if (has_adaptive) add({style::kFaintInk, 1.5, "solid"}, "GSL's steppers, over tolerances", "");
    const double x = kLeft - 40 + 375.0 * static_cast<double>(place / 4);
    const double y = kKeyTop + kKeyLine * static_cast<double>(place % 4);
    script_ += fmt::format("set label '' at {} point pt 6 ps 1.4 lw 1.5 lc rgb '{}'\n",
                           screen(kCanvas, x + 15, y), style::kInk);
    script_ += fmt::format(
        "set label 'Pareto front: nothing is cheaper and nearer' at {} left font ',13' tc rgb '{}'\n",
        screen(kCanvas, x + 38, y), style::kInk);
  }

  void write_sentence() {
    const std::string sentence = convergence_sentence(study_);
    // Two lines of the card's width.
    const std::size_t middle = sentence.find(' ', sentence.size() / 2);
    script_ += fmt::format("set label {} at {} left tc rgb '{}'\n", quoted(sentence.substr(0, middle)),
                           screen(kCanvas, style::kMargin, 708), style::kVermilion);
    if (middle != sentence.npos)
      script_ += fmt::format("set label {} at {} left tc rgb '{}'\n", quoted(sentence.substr(middle + 1)),
                             screen(kCanvas, style::kMargin, 730), style::kVermilion);
  }

  const SpeedError& study_;
  std::vector<Curve> curves_;
  double nothing_px_;
  std::string script_;
};

}  // namespace

std::string speed_error_script(const SpeedError& study, std::size_t problem, const std::string& machine) {
  return Diagram(study, problem, machine).take();
}

std::string convergence_sentence(const SpeedError& study) {
  const PaperErrors* at_60 = nullptr;
  for (const PaperErrors& paper : study.paper)
    if (paper.rate_hz == 60.0) at_60 = &paper;
  if (at_60 == nullptr) return "";
  const PaperErrors& last = study.paper.back();
  return fmt::format(
      "Drag by the frame keeps the paper's step from converging: each frame takes 0.1 % of the speed however "
      "short it is, so that after a second in the air {:.3g} px of error at 60 Hz become {:.3g} px at {:.0f} "
      "Hz.",
      at_60->model_px, last.model_px, last.rate_hz);
}

}  // namespace hyrax
