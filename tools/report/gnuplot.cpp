#include "tools/report/gnuplot.h"

#include <algorithm>
#include <sstream>
#include <vector>

#include <fmt/format.h>

#include "tools/files/atomic_file.h"
#include "tools/files/child_process.h"
#include "tools/report/figure_style.h"

namespace hyrax {
namespace {

// A label among data has an edge of paper, by which it is readable over a line.
// out = floor + span * (1 + in - 2 * luminance(in)), per channel: white becomes #0d1117, black #edf1f7.
constexpr std::string_view kStyle =
    "<style>@media (prefers-color-scheme: dark) {{ #gnuplot_canvas {{ filter: url(#dark) }} }}\n"
    "g[font-size=\"{size:.2f}\"] text {{ paint-order: stroke; stroke: {paper}; stroke-width: 3px }}</style>\n"
    "<filter id=\"dark\" filterUnits=\"userSpaceOnUse\" x=\"0\" y=\"0\" width=\"100%\" height=\"100%\" "
    "color-interpolation-filters=\"sRGB\"><feColorMatrix values=\""
    "0.506 -1.259 -0.127 0 0.93 "
    "-0.374 -0.379 -0.127 0 0.945 "
    "-0.374 -1.259 0.753 0 0.97 "
    "0 0 0 1 0\"/></filter>\n";

std::string escaped(std::string_view text) {
  std::string result;
  for (const char letter : text) {
    if (letter == '<')
      result += "&lt;";
    else if (letter == '&')
      result += "&amp;";
    else
      result += letter;
  }
  return result;
}

// What stands between the quote at the text's start and the one that ends it; gnuplot doubles a quote within.
std::string unquoted(std::string_view text) {
  std::string result;
  for (std::size_t at = 1; at < text.size(); ++at) {
    if (text[at] == '\'' && text.substr(at, 2) != "''") break;
    if (text[at] == '\'') ++at;
    result += text[at];
  }
  return result;
}

std::string title_of(std::string_view script) {
  return script.starts_with("# ") ? std::string(script.substr(2, script.find(" #\n") - 2)) : "Figure";
}

// The titles in the script's plot commands, in order.
std::vector<std::string> series_of(std::string_view script) {
  constexpr std::string_view kTitle = " title '";
  std::vector<std::string> names;
  for (std::size_t line = 0, end = 0; line < script.size(); line = end + 1) {
    end = std::min(script.find('\n', line), script.size());
    const std::string_view command = script.substr(line, end - line);
    if (!command.starts_with("plot ")) continue;
    for (std::size_t at = command.find(kTitle); at != command.npos; at = command.find(kTitle, at + 1))
      names.push_back(unquoted(command.substr(at + kTitle.size() - 1)));
  }
  return names;
}

// What gnuplot's SVG lacks: the title in the script's first line "# TITLE #" as its `<title>`; the titles in
// its plot commands as those of the curves, which gnuplot writes only with enhanced text; a dark mode, where
// a filter inverts the lightness and keeps the hues, so that every contrast of the light picture remains.
std::string finished_svg(std::string svg, std::string_view script) {
  constexpr std::string_view kTitle = "<title>Gnuplot</title>\n";
  constexpr std::string_view kMadeUp = "<title>gnuplot_plot_";
  constexpr std::string_view kEnd = "</title>";
  if (const std::size_t at = svg.find(kTitle); at != svg.npos)
    svg.replace(
        at, kTitle.size(),
        "<title>" + escaped(title_of(script)) + "</title>\n" +
            fmt::format(kStyle, fmt::arg("size", style::kLabelSize), fmt::arg("paper", style::kPaper)));
  std::size_t at = 0;
  for (const std::string& name : series_of(script)) {
    at = svg.find(kMadeUp, at);
    if (at == svg.npos) break;
    svg.replace(at, svg.find(kEnd, at) - at, "<title>" + escaped(name));
  }
  while ((at = svg.find(kMadeUp, std::min(at, svg.size()))) != svg.npos)
    svg.erase(at, svg.find(kEnd, at) + kEnd.size() - at);
  return svg;
}

// gnuplot's words in one line.
std::string in_one_line(const std::string& text) {
  std::string line;
  std::istringstream words(text);
  for (std::string word; words >> word;) line += (line.empty() ? "" : " ") + word;
  return line;
}

ChildEnd run_gnuplot(const std::string& path, const std::string& script) {
  try {
    return run_child({"gnuplot", "--default-settings"}, script, std::nullopt);
  } catch (const CannotStart& error) {
    throw Failure(ExitCode::cannot_access,
                  path + ": cannot be drawn: " +
                      (error.is_missing()
                           ? "gnuplot is not installed; `apt-get install gnuplot-nox`, or tools/run does it"
                           : error.what()));
  }
}

}  // namespace

void draw_figure(const std::string& path, const std::string& script) {
  AtomicFile file(path);
  const ChildEnd end = run_gnuplot(path, script);
  if (end.exit_code != 0)
    throw Failure(ExitCode::program_fault, path + ": cannot be drawn: gnuplot says: " + in_one_line(end.err));
  if (end.out.find("</svg>") == end.out.npos)
    throw Failure(ExitCode::program_fault, path + ": cannot be drawn: gnuplot wrote no complete picture");
  file.write(finished_svg(end.out, script));
  file.commit();
}

}  // namespace hyrax
