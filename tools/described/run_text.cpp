#include "tools/described/run_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/result/number_text.h"
#include "sim/trajectory/run_summary.h"
#include "tools/app/comparison/comparison_text.h"
#include "tools/described/value_json.h"

namespace hyrax {
namespace {

constexpr const char* kLeftOut = "set, an action, hold or go";

std::string with_unit(const std::string& text, const ValueInfo& value) {
  return value.unit.empty() ? text : text + " " + value.unit;
}

// Floating values in hex float, too.
std::string exact_text(const ValueInfo& value, const std::optional<Word>& word) {
  if (!word) return "not stored in the golden file";
  const std::string text = with_unit(value_text(value, *word), value);
  if (!is_floating(value.type)) return text;
  return fmt::format("{}  ({})", text, hex_float(number_of(value.type, *word)));
}

std::string divergence_text(const DescribedDivergence& first) {
  std::string text = comparison_line(
      "first", fmt::format("step {} ({:.4g} s), {}", first.step, first.t_s, first.value.name));
  if (!first.expected && !first.actual)
    return text + "  the hash of the block of 4,096 rows from this step differs; its rows are not known\n";
  text += comparison_line("expected", exact_text(first.value, first.expected)) +
          comparison_line("actual", exact_text(first.value, first.actual));
  if (const std::string ulps = ulps_text(first.ulps()); !ulps.empty())
    text += comparison_line("distance", ulps);
  return text;
}

std::string maxima_text(const std::map<std::string, double>& max) {
  std::string text;
  for (const auto& [unit, value] : max)
    if (value > 0.0)
      text += fmt::format("{}{}{}", text.empty() ? "" : ", ", rounded(value, 3),
                          unit.empty() ? " of values without unit" : " " + unit);
  return text;
}

}  // namespace

std::string contacts_text(const Description& description, const DescribedSummary& summary) {
  std::string text;
  for (std::size_t index = 0; index < description.contacts.size(); ++index)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", description.contacts[index],
                        summary.contacts[index]);
  return text.empty() ? "none" : text;
}

std::string why_not_settled(const Description& description, const DescribedSummary& summary) {
  if (std::ranges::find(description.state.values, "px", &ValueInfo::unit) == description.state.values.end())
    return "no value is in px";
  return summary.simulated_s < RestAnchor::kLeastRest_s ? "the run is shorter than 1 s"
                                                        : "moved within the last 1 s";
}

std::string state_text(const Description& description, const std::vector<Word>& state,
                       std::size_t values_max) {
  std::string text;
  for (std::size_t index = 0; index < std::min(state.size(), values_max); ++index) {
    const ValueInfo& value = description.state.values[index];
    const std::string number = is_floating(value.type)
                                   ? fmt::format("{:.6g}", number_of(value.type, state[index]))
                                   : value_text(value, state[index]);
    text += fmt::format("{}{} {}", index == 0 ? "" : ", ", value.name, with_unit(number, value));
  }
  return state.size() <= values_max ? text : fmt::format("{} and {} more", text, state.size() - values_max);
}

std::vector<std::string> faults_of_run(const Description& description, const DescribedSummary& summary) {
  std::vector<std::string> faults;
  if (const std::optional<EarlyEnd>& end = summary.early_end)
    faults.push_back(fmt::format("row {}: {}; the run ended there", end->step, end->what));
  for (std::size_t index = 0; index < summary.properties.size(); ++index) {
    const PropertyOutcome& outcome = summary.properties[index];
    if (!description.properties[index].is_always || outcome.holds) continue;
    faults.push_back(fmt::format("property \"{}\" does not hold at step {} ({:.6g} s)",
                                 description.properties[index].name, outcome.step.value_or(0), outcome.t_s));
  }
  return faults;
}

std::string comparison_sentence(const DescribedComparison& comparison) {
  const std::string shape = comparison.shape.empty() ? "" : comparison.shape + "; ";
  const std::string maxima = maxima_text(comparison.max);
  const std::string contacts = contacts_text(comparison.contacts);
  if (comparison.first && !comparison.first->expected)
    return fmt::format(
        "{}differs within the 4,096 rows from step {}, which the golden file does not hold; {}", shape,
        comparison.first->step, contacts);
  const std::string apart = comparison.has_px || comparison.distance.has_unknown_rows
                                ? distance_text(comparison.distance, kLeftOut)
                                : "differs by " + (maxima.empty() ? "nothing that is recorded" : maxima);
  return comparison.first ? fmt::format("{}{}, {}; first {} at step {}", shape, apart, contacts,
                                        comparison.first->value.name, comparison.first->step)
                          : shape + apart + ", " + contacts;
}

std::string comparison_text(const DescribedComparison& comparison) {
  std::string text;
  if (comparison.has_px || comparison.distance.has_unknown_rows)
    text += comparison_line("farthest", distance_text(comparison.distance, kLeftOut));
  if (const std::string maxima = maxima_text(comparison.max); !maxima.empty())
    text += comparison_line("largest", maxima);
  text += comparison_line("contacts", contacts_text(comparison.contacts));
  if (comparison.difference) text += comparison_line("class", std::string(name_of(*comparison.difference)));
  if (!comparison.shape.empty()) text += comparison_line("shape", comparison.shape);
  if (comparison.first) text += divergence_text(*comparison.first);
  return text;
}

Json::Object comparison_json(const DescribedComparison& comparison) {
  Json first;
  if (comparison.first) {
    const DescribedDivergence& from = *comparison.first;
    const auto json = [&](const std::optional<Word>& word) {
      return word ? value_json(from.value, *word) : Json();
    };
    first = Json::Object{{"step", from.step},
                         {"field", from.value.name},
                         {"expected", json(from.expected)},
                         {"actual", json(from.actual)},
                         {"ulps", or_null(from.ulps())}};
  }
  Json::Object max;
  for (const auto& [unit, value] : comparison.max) max.emplace_back(unit, value);
  return {{"class", comparison.difference ? Json(name_of(*comparison.difference)) : Json()},
          {"max_px", or_null(comparison.max_px())},
          {"max", std::move(max)},
          {"contacts_moved", comparison.contacts.total()},
          {"first_divergence", std::move(first)}};
}

FileRun::FileRun(const DescribedCore& core, const std::string& path)
    : file_(DescribedFile::open(path, core.description.core)),
      picture_(file_.head().description, file_.head().scenario) {
  summary_.steps = file_.head().steps;
  summary_.contacts.resize(file_.head().description.contacts.size());
  for (const DescribedContact& contact : file_.contacts()) ++summary_.contacts[contact.contact];
  file_.show(*this);
}

void FileRun::row(const DescribedRow& row) {
  picture_.row(row);
  summary_.simulated_s = row.t_s;
  summary_.final.assign(row.state.begin(), row.state.end());
}

ShownResult shown_run(const Description& description, const DescribedScenario& scenario,
                      const DescribedSummary& summary, const DescribedPicture& picture,
                      const DescribedPicture* golden, const std::string& found,
                      std::vector<std::pair<std::string, std::string>> origin) {
  ShownResult shown{.title = scenario.name,
                    .subtitle = scenario.description.value_or(""),
                    .tables = {picture.rows()},
                    .figures = {picture.figure(found, golden)},
                    .origin = std::move(origin)};
  shown.verdict.text = {
      "Contacts: " + contacts_text(description, summary),
      "End: " + state_text(description, summary.final, summary.final.size()),
      "The page replays cores of the paper's interface; of " + description.core + " it shows the rows."};
  return shown;
}

Sheet panel_picture(const DescribedPicture& picture, const DescribedPicture* golden) {
  const Figure figure = picture.figure("", golden);
  const auto& plots = std::get<std::vector<Plot>>(figure.body);
  return plots.empty() ? Sheet() : plot_panel(plots.front());
}

void write_run_pages(const std::string& path, const std::string& command, const std::vector<RunPanel>& panels,
                     std::vector<ShownResult> runs) {
  if (panels.size() > 1) runs.insert(runs.begin(), {.title = sheet_title(panels), .panels = panels});
  write_result_page(path, command, runs);
}

}  // namespace hyrax
