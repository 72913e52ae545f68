// The frame that the pictures of a run's errors share: paper, axes, bands for arcs, legend.
#pragma once

#include <string>
#include <string_view>

#include "tools/report/drift_figures.h"
#include "tools/report/figure_style.h"

namespace hyrax {

class DriftPlot {
 public:
  /// @param subtitle what the picture shows; @param y_label with its unit, above the axis.
  DriftPlot(const DriftPicture& picture, std::string_view subtitle, std::string_view x_label,
            std::string_view y_label);

  /// Time from 0 to the end of the last arc; every other arc on a darker band, and a dot at the top for
  /// every wall that ended one. Of more arcs than can be told apart, neither.
  void mark_arcs();
  /// Any command of gnuplot's, with its end of line.
  void add(const std::string& command) { commands_ += command; }
  void add_block(std::string_view name, const std::string& lines);

  // The legend, from left to right.
  void explain_line(std::string_view words, std::string_view colour, double width, std::string_view dashes);
  void explain_dot(std::string_view words, std::string_view colour);
  void explain_band(std::string_view words);

  /// The script, ending in this plot command; or, where there is nothing to show, saying why.
  [[nodiscard]] std::string script(const std::string& plot_command) const;
  [[nodiscard]] std::string script_of_nothing(std::string_view why) const;

 private:
  void explain(std::string_view words, double sign);

  const DriftPicture& picture_;
  Canvas canvas_{960, 440};
  double legend_x_;
  std::string commands_;
};

[[nodiscard]] std::string_view wall_colour(Wall wall);

/// A power of ten as people write it, "10⁻¹²".
[[nodiscard]] std::string power_of_ten(int exponent);

}  // namespace hyrax
