// A contact sheet: small pictures of many runs, each with its verdict.
#pragma once

#include <string>
#include <vector>

#include "tools/report/svg.h"

namespace hyrax {

inline constexpr double kPanelWidth = 202.0;   ///< Of a panel's picture, at most; in px,
inline constexpr double kPanelHeight = 130.0;  ///< as its height.

/// One run.
struct RunPanel {
  std::string name;          ///< Of its scenario.
  std::string status;        ///< "agreed", "disagreed", "missing", "played" or "failed".
  Sheet picture = {};        ///< No wider or higher than a panel's; empty: none.
  std::string link = {};     ///< Where a click leads on a page; empty: the picture grows, with the
  std::string text = {};     ///< text below it, and
  std::string command = {};  ///< a command that shows more.
};

/// Its lines and points, without axes and texts, for a panel.
[[nodiscard]] Sheet plot_panel(const Plot& plot);

/// "116 scenarios: 2 disagreed, 114 agreed".
[[nodiscard]] std::string sheet_title(const std::vector<RunPanel>& panels);

/// The text of an SVG file. Runs that do not agree come first; a verdict is a border, a mark and a word.
[[nodiscard]] std::string contact_sheet_svg(std::vector<RunPanel> panels);
/// The same as an element of a page, with the id "runs". @param has_title of its own.
[[nodiscard]] std::string contact_sheet_html(std::vector<RunPanel> panels, bool has_title);

}  // namespace hyrax
