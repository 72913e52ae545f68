// The frame of a picture of numbers: card, white paper where the data are, quiet axes, a legend below.
#pragma once

#include <string>
#include <string_view>

#include "tools/report/figure_style.h"

namespace hyrax {

class PlotFrame {
 public:
  /// @param y_label with its unit, above the axis.
  PlotFrame(std::string_view title, std::string_view subtitle, std::string_view x_label,
            std::string_view y_label, Canvas canvas = {960, 480});

  /// In quiet ink, at the right of the title.
  void note(std::string_view words);
  /// Any command of gnuplot's, with its end of line.
  void add(const std::string& command) { commands_ += command; }
  void add_block(std::string_view name, const std::string& lines);
  /// A logarithmic axis of display rates, from low to high, ticked at rates of displays.
  void use_rate_axis(double low_hz, double high_hz);
  /// A dashed upright line at x, and its words at the top.
  void mark(double x, std::string_view words);

  // The legend, from left to right.
  void explain_line(std::string_view words, std::string_view colour, double width = 2.5,
                    std::string_view dashes = "solid");
  void explain_area(std::string_view words, std::string_view colour);
  /// @param point_type as gnuplot numbers them.
  void explain_dot(std::string_view words, std::string_view colour, int point_type = 7);

  /// The script, ending in this plot command; or, where there is nothing to show, saying why.
  [[nodiscard]] std::string script(const std::string& plot_command) const {
    return commands_ + plot_command + "\n";
  }
  [[nodiscard]] std::string script_of_nothing(std::string_view why) const;

 private:
  void explain(std::string_view words, double sign_width);

  Canvas canvas_;
  double legend_x_;
  int next_object_ = 3;
  std::string commands_;
};

/// A power of ten as people write it, "10⁻¹²".
[[nodiscard]] std::string power_of_ten(int exponent);

}  // namespace hyrax
