#include "tools/report/plot_scale.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "sim/result/number_text.h"
#include "tools/report/look.h"

namespace hyrax {
namespace {

bool is_given(double value) { return !std::isnan(value); }

// 1, 2 or 5 times a power of ten, at least `least`.
double round_step(double least) {
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double times : {1.0, 2.0, 5.0})
    if (times * power >= least * (1.0 - 1e-12)) return times * power;
  return 10.0 * power;
}

std::string tick_text(double value, int decimals) {
  std::string text =
      std::fabs(value) >= 1e7 || decimals > 6 ? rounded(value, 6) : with_decimals(value, decimals);
  for (std::size_t at = text.find('-'); at != text.npos; at = text.find('-', at)) text.replace(at, 1, "−");
  return text;
}

}  // namespace

PlotScale::PlotScale(const Axis& axis, const std::vector<double>& values) : axis_(axis) {
  if (!axis.categories.empty()) {
    ranges_ = {{-0.5, static_cast<double>(axis.categories.size()) - 0.5}};
    return;
  }
  const double split = is_given(axis.strip_below) ? axis.strip_below : -HUGE_VAL;
  Range strip{HUGE_VAL, -HUGE_VAL}, rest = strip;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    const bool is_zero = is_given(axis.zero_at) && value <= axis.zero_at;
    has_zeros_ = has_zeros_ || is_zero;
    const double shown = is_zero ? axis.zero_at : value;
    if (axis.is_logarithmic && shown <= 0.0) continue;
    Range& range = shown <= split ? strip : rest;
    range.low = std::min(range.low, shown);
    range.high = std::max(range.high, shown);
  }
  const bool has_rest = rest.low <= rest.high, has_strip = strip.low <= strip.high;
  constexpr double kEmptyTimes = 100.0;  // Decades that a strip is for.
  if (has_strip && has_rest && rest.low > kEmptyTimes * strip.high)
    ranges_ = {ends_of(strip.low, strip.high), ends_of(rest.low, rest.high)};
  else if (has_strip || has_rest)
    ranges_ = {ends_of(std::min(strip.low, rest.low), std::max(strip.high, rest.high))};
  else
    ranges_ = {axis.is_logarithmic ? Range{1.0, 10.0} : Range{0.0, 1.0}};
  if (is_given(axis.low)) ranges_.front().low = axis.low;
  if (is_given(axis.high)) ranges_.back().high = axis.high;
}

PlotScale::Range PlotScale::ends_of(double low, double high) const {
  constexpr double kSpace = 0.05;
  if (axis_.is_logarithmic) {
    const double factor = std::max(1.4, std::pow(high / low, kSpace));
    return {low / factor, high * factor};
  }
  const double space = high > low ? kSpace * (high - low) : 0.5 * std::max(std::fabs(low), 1.0);
  return {low - space, high + space};
}

void PlotScale::place(double low_px, double high_px, double apart_px) {
  constexpr double kStrip = 0.27;  // Of the axis's length.
  constexpr double kGap_px = 10.0;
  apart_px_ = apart_px;
  if (axis_.is_reversed) std::swap(low_px, high_px);
  ranges_.front().low_px = low_px;
  ranges_.back().high_px = high_px;
  if (ranges_.size() == 1) return;
  const double direction = high_px > low_px ? 1.0 : -1.0;
  ranges_.front().high_px = low_px + kStrip * (high_px - low_px);
  ranges_.back().low_px = ranges_.front().high_px + direction * kGap_px;
}

void PlotScale::make_equal(PlotScale& x, PlotScale& y) {
  const auto per_px = [](const Range& range) {
    return (range.high - range.low) / std::fabs(range.high_px - range.low_px);
  };
  const double factor = per_px(y.ranges_.front()) / per_px(x.ranges_.front());
  PlotScale& widened = factor > 1.0 ? x : y;
  if (is_given(widened.axis_.low)) return;
  Range& range = widened.ranges_.front();
  const double space = 0.5 * (std::max(factor, 1.0 / factor) - 1.0) * (range.high - range.low);
  range.low -= space;
  range.high += space;
}

const PlotScale::Range& PlotScale::range_of(double value) const {
  return value <= axis_.strip_below ? ranges_.front() : ranges_.back();
}

double PlotScale::at(double value) const {
  if (is_given(axis_.zero_at) && value <= axis_.zero_at) value = axis_.zero_at;
  if (axis_.is_logarithmic && value <= 0.0) return kNotGiven;
  const Range& range = range_of(value);
  const double place = axis_.is_logarithmic ? std::log(value / range.low) / std::log(range.high / range.low)
                                            : (value - range.low) / (range.high - range.low);
  return range.low_px + place * (range.high_px - range.low_px);
}

double PlotScale::clamped(double value) const {
  const Range& range = range_of(value);
  return at(std::clamp(value, range.low, range.high));
}

std::string PlotScale::text() const {
  std::string ranges;
  for (const auto& [low, high, low_px, high_px] : ranges_)
    ranges +=
        fmt::format("{}{:.6g} {:.6g} {:.9g} {:.9g}", ranges.empty() ? "" : ";", low_px, high_px, low, high);
  return (axis_.is_logarithmic ? "log|" : "even|") + ranges + "|" + axis_.label;
}

std::optional<double> PlotScale::end_of_strip() const {
  return ranges_.size() == 1 ? std::nullopt : std::optional(ranges_.front().high_px);
}

void PlotScale::add_powers_of_ten(std::vector<Tick>& ticks, const Range& range) const {
  constexpr double kTick_px = 15.0;                                                    // Height of a text.
  const auto is_plain = [](int exponent) { return exponent >= -3 && exponent <= 4; };  // Read more easily.
  const int low = static_cast<int>(std::ceil(std::log10(range.low) - 1e-9));
  const int high = static_cast<int>(std::floor(std::log10(range.high) + 1e-9));
  const double px_a_decade = std::fabs(range.high_px - range.low_px) / std::log10(range.high / range.low);
  const int every = std::max(1, static_cast<int>(std::ceil(0.6 * apart_px_ / px_a_decade)));
  const auto add = [&](double at, const std::string& text) {
    const bool is_inside = at >= range.low * (1.0 - 1e-9) && at <= range.high * (1.0 + 1e-9);
    const bool is_over_zero = has_zeros_ && std::fabs(this->at(at) - this->at(axis_.zero_at)) < kTick_px;
    if (is_inside && !(at <= axis_.zero_at * 1.01) && !is_over_zero) ticks.push_back({at, text});
  };
  const bool has_between = high - low < 1;
  for (int exponent = low - 1; exponent <= high; ++exponent) {
    const double power = std::pow(10.0, exponent);
    if (exponent % every == 0) add(power, is_plain(exponent) ? rounded(power) : power_of_ten(exponent));
    for (const double times : {2.0, 5.0})
      if (has_between) add(times * power, rounded(times * power));
  }
}

void PlotScale::add_round_numbers(std::vector<Tick>& ticks) const {
  const Range& range = ranges_.front();
  const double span = range.high - range.low;
  double step = round_step(span * apart_px_ / std::fabs(range.high_px - range.low_px));
  if (std::floor(range.high / step) <= std::ceil(range.low / step))
    step = round_step(0.4 * step);  // One is no scale.
  const int needed = std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9)));
  const double first = std::ceil(range.low / step - 1e-9);
  for (double index = 0.0; index * step <= range.high - first * step + 1e-9 * span; index += 1.0) {
    const double at = (first + index) * step;
    if (!ticks.empty() && at <= ticks.back().at) continue;  // Numbers this large are farther apart.
    ticks.push_back({at, tick_text(at, std::max(axis_.decimals, needed))});
  }
}

std::vector<Tick> PlotScale::ticks() const {
  std::vector<Tick> ticks;
  if (!axis_.categories.empty()) {
    for (const std::string& category : axis_.categories)
      ticks.push_back({static_cast<double>(ticks.size()), category});
    return ticks;
  }
  if (has_zeros_) ticks.push_back({axis_.zero_at, axis_.zero_text});
  for (const Tick& tick : axis_.ticks)
    if (tick.at >= ranges_.front().low && tick.at <= ranges_.back().high) ticks.push_back(tick);
  std::ranges::sort(ticks, {}, &Tick::at);
  if (!axis_.ticks.empty()) return ticks;
  if (!axis_.is_logarithmic) add_round_numbers(ticks);
  for (const Range& range : ranges_)
    if (axis_.is_logarithmic) add_powers_of_ten(ticks, range);
  return ticks;
}

}  // namespace hyrax
