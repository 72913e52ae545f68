#include "sim/study/needs/needs.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "sim/result/number_text.h"

namespace hyrax {
namespace {

constexpr std::size_t kPartsDrawnMax = 40;

// The groups of parts that have a colour each.
struct Group {
  Tone tone;
  const char* text;
};
constexpr std::array<Group, 3> kGroups = {{{Tone::blue, "needed"},
                                           {Tone::orange, "changes something, below the tolerance"},
                                           {Tone::hairline, "not exercised: not one bit changes"}}};

std::size_t group_of(Need need) {
  if (need == Need::not_exercised) return 2;
  return need == Need::below ? 1 : 0;
}

std::vector<LegendEntry> legend() {
  std::vector<LegendEntry> entries;
  entries.reserve(kGroups.size());
  for (const Group& group : kGroups)
    entries.push_back({group.text, {.form = Form::bars, .tone = group.tone}});
  return entries;
}

std::string text_of(const PartNeed& part) {
  if (part.need == Need::not_exercised) return "not exercised";
  const PathDifference& difference = part.difference;
  std::string text = difference.path_px == 0.0 ? "only the speed changes" : length_text(difference.path_px);
  if (difference.contacts_moved > 0)
    text += fmt::format(", {} moved", plain_counted(difference.contacts_moved, "contact"));
  return part.need == Need::needed_jointly ? text + ", needed with others left out" : text;
}

}  // namespace

std::string length_text(double length_px) {
  if (!std::isfinite(length_px)) return "without bound";
  return rounded(length_px, 3) + " px";
}

Figure needs_figure(const ScenarioNeeds& needs, double within_px) {
  const std::size_t count = std::min(needs.parts.size(), kPartsDrawnMax);
  // Of the bars, in px: the shortest, and the longest, which those without bound have, too.
  double low_px = within_px > 0.0 ? within_px / 10.0 : 1e-3;
  double longest_px = std::max(100.0, 10.0 * within_px);
  for (const PartNeed& part : needs.parts) {
    const double path_px = part.difference.path_px;
    if (path_px > 0.0) low_px = std::min(low_px, path_px / 2.0);
    if (std::isfinite(path_px)) longest_px = std::max(longest_px, path_px);
  }
  // Distances far below the tolerance need no bars of different lengths.
  low_px = std::max(low_px, within_px > 0.0 ? within_px * 1e-4 : 1e-15);
  const double room_for_text = std::pow(longest_px / low_px, 0.4);
  Plot plot{.x = {.label = "largest distance at equal times, px",
                  .is_logarithmic = true,
                  .low = low_px,
                  .high = longest_px * room_for_text}};
  for (const Group& group : kGroups)
    plot.series.push_back({.name = group.text, .look = {.form = Form::bars, .tone = group.tone}});
  for (std::size_t index = 0; index < count; ++index) {
    const PartNeed& part = needs.parts[index];
    const auto y = static_cast<double>(index);
    const double end_px = std::clamp(part.difference.path_px, low_px, longest_px);
    plot.y.categories.push_back(part.part);
    Series& series = plot.series[group_of(part.need)];
    series.x.push_back(end_px);
    series.y.push_back(y);
    plot.texts.push_back(
        {end_px, y, text_of(part), part.need == Need::not_exercised ? Tone::quiet : Tone::ink});
  }
  if (within_px > 0.0) plot.marks.push_back({.at = within_px, .text = "tolerance", .tone = Tone::vermilion});
  return {.suffix = "-" + needs.scenario,
          .title = "What " + needs.scenario + " needs",
          .subtitle = fmt::format(
              "How far its path moves when a part is left out: {} of {} parts are needed within {:g} px",
              std::ssize(needs.parts) - unneeded_count(needs), needs.parts.size(), within_px),
          .note = count < needs.parts.size()
                      ? fmt::format("the first {} of {} parts", count, needs.parts.size())
                      : "",
          .body = std::vector{std::move(plot)},
          .legend = legend()};
}

Figure coverage_figure(const std::vector<ScenarioNeeds>& scenarios, double within_px) {
  const std::vector<std::string> never = never_exercised(scenarios);
  Grid grid;
  for (const std::string& column : coverage_columns()) {
    const bool is_never = std::find(never.begin(), never.end(), column) != never.end();
    grid.columns.emplace_back(column + (is_never ? " (never)" : ""), is_never ? Tone::vermilion : Tone::ink);
  }
  for (const ScenarioNeeds& needs : scenarios) {
    const std::vector<Need> coverage = coverage_of(needs);
    for (std::size_t column = 0; column < coverage.size(); ++column)
      grid.cells.push_back(
          {.row = grid.rows.size(), .column = column, .tone = kGroups[group_of(coverage[column])].tone});
    grid.rows.push_back(needs.scenario);
  }
  return {.title = "What the scenarios exercise",
          .subtitle = fmt::format("Each part of the model and each input left out in turn; tolerance {:g} px",
                                  within_px),
          .body = std::move(grid),
          .legend = legend()};
}

}  // namespace hyrax
