// Where values are on an axis, in px, and its ticks.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/result/figure.h"

namespace hyrax {

class PlotScale {
 public:
  /// Ends of the axis that are not given are those of the values, and some space.
  PlotScale(const Axis& axis, const std::vector<double>& values);

  /// @param low_px, high_px where the ends of the axis are; where it is reversed, of the high and the low
  /// end.
  /// @param apart_px between two ticks, at least.
  void place(double low_px, double high_px, double apart_px);
  /// Makes 1 px of the data as long in x as in y: widens one of the axes to both sides, unless its ends are
  /// given.
  static void make_equal(PlotScale& x, PlotScale& y);

  /// NaN for what has no place, as 0 on a logarithmic axis without zero_at.
  [[nodiscard]] double at(double value) const;
  /// The nearest place on the axis.
  [[nodiscard]] double clamped(double value) const;
  /// In order, distinct, none beyond the ends.
  [[nodiscard]] std::vector<Tick> ticks() const;

  /// For the script of a page: "log|PX PX VALUE VALUE;...|LABEL", of each range where it is and its ends.
  [[nodiscard]] std::string text() const;

  /// Where the strip of the axis ends beside the rest, if it has a strip and data in both.
  [[nodiscard]] std::optional<double> end_of_strip() const;

 private:
  struct Range {
    double low = 0.0, high = 0.0;
    double low_px = 0.0, high_px = 0.0;
  };
  [[nodiscard]] Range ends_of(double low, double high) const;
  [[nodiscard]] const Range& range_of(double value) const;
  void add_powers_of_ten(std::vector<Tick>& ticks, const Range& range) const;
  void add_round_numbers(std::vector<Tick>& ticks) const;

  const Axis& axis_;
  std::vector<Range> ranges_;  // From the low end; two if the axis has a strip.
  bool has_zeros_ = false;     // Of a logarithmic axis: data at zero_at.
  double apart_px_ = 0.0;
};

}  // namespace hyrax
