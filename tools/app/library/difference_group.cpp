#include "tools/app/library/difference_group.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "sim/result/number_text.h"
#include "tools/app/comparison/comparison_text.h"
#include "tools/files/printable.h"

namespace hyrax {
namespace {

constexpr std::size_t kWorstListed = 3;

bool is_non_finite(const DifferenceGroup& group) { return group.cause.kind == CauseKind::non_finite; }

// Three digits say how far; more are in the JSON document.
std::string px_text(double px) { return rounded(px, 3) + " px"; }

// Contacts that moved are of no wider class where the rows are not known; others are not compared.
std::string_view class_text(const DifferenceGroup& group) {
  switch (group.difference) {
    case DifferenceClass::rounding:
      return "Rounding only";
    case DifferenceClass::values:
      return group.contacts.is_cut || group.contacts.total() > 0 ? "Values differ"
                                                                 : "Values differ, contacts do not";
    case DifferenceClass::contacts:
      return "Contacts differ";
    case DifferenceClass::shape:
      return "Another shape";
  }
  return "";
}

// Said of runs that settle only.
std::string rest_text(const DifferenceGroup& group) {
  if (!group.rest_shift_px) return "";
  const bool do_all_settle = group.settled == group.scenarios.size();
  if (*group.rest_shift_px == 0.0) return do_all_settle ? ", comes to rest at the same place" : "";
  const std::string subject =
      do_all_settle ? "comes to rest"
                    : fmt::format("{} of {} come to rest,", group.settled, group.scenarios.size());
  return fmt::format(", {} up to {} away", subject, px_text(*group.rest_shift_px));
}

// Where nothing explains a difference, where it begins.
std::string first_text(const DifferenceGroup& group) {
  const std::string first = group.scenarios.front()->first_difference();
  if (group.cause.kind != CauseKind::unknown || first.empty()) return "";
  return fmt::format("  first   {} of {}\n", first, printable(group.scenarios.front()->path));
}

std::string lead_of(CauseKind kind) {
  if (kind == CauseKind::unknown) return "; cause unknown: ";
  return kind == CauseKind::scenario ? ": the scenario changed since it was blessed: " : ": ";
}

std::string worst_text(const DifferenceGroup& group) {
  std::string text = first_text(group);
  const std::size_t listed = std::min(group.scenarios.size(), kWorstListed);
  for (std::size_t index = 0; index < listed; ++index)
    text += fmt::format("  {:<8}{}: {}\n", index == 0 ? "worst" : "", printable(group.scenarios[index]->path),
                        group.scenarios[index]->consequence());
  if (group.scenarios.size() > listed)
    text += fmt::format("  {:<8}and {} more\n", "", group.scenarios.size() - listed);
  return text;
}

Paragraph paragraph_of(const DifferenceGroup& group, std::size_t checked) {
  const std::size_t scenarios = group.scenarios.size();
  Paragraph paragraph{.subject = fmt::format("{} of {} ", scenarios, plain_counted(checked, "scenario")),
                      .verdict = scenarios == 1 ? "differs" : "differ",
                      .lines = fmt::format("  {}\n{}", consequence_sentence(group), worst_text(group))};
  std::string& predicate = paragraph.predicate;
  predicate = lead_of(group.cause.kind) + group.cause.detail;
  if (is_non_finite(group)) {
    paragraph.verdict = scenarios == 1 ? "becomes non-finite" : "become non-finite";
    predicate = fmt::format(": {}{}", scenarios == 1 ? "" : "in the worst, ", group.cause.detail);
  } else if (group.is_proved) {
    predicate += scenarios == 1 ? "; the accepted core gives its golden file"
                                : fmt::format("; the accepted core gives all {} golden files", scenarios);
  }
  predicate += ".";
  return paragraph;
}

Paragraph paragraph_of(const std::string& core) {
  const std::size_t end = std::min(core.find('\n'), core.size());
  return {.subject = core.substr(0, end), .lines = core.substr(std::min(end + 1, core.size()))};
}

std::tuple<double, std::int64_t> badness(const ScenarioVerdict* scenario) {
  const Deviation deviation = scenario->deviation();
  return {deviation.px.value_or(0.0), deviation.contacts.total()};
}

}  // namespace

DifferenceGroup make_group(Cause cause, std::vector<const ScenarioVerdict*> scenarios) {
  DifferenceGroup group{.cause = std::move(cause),
                        .scenarios = std::move(scenarios),
                        .max_px = {},
                        .contacts = {},
                        .rest_shift_px = {}};
  std::ranges::stable_sort(group.scenarios, std::ranges::greater(), badness);
  for (const ScenarioVerdict* const scenario : group.scenarios) {
    const Deviation deviation = scenario->deviation();
    if (deviation.difference) group.difference = std::max(group.difference, *deviation.difference);
    if (deviation.px) group.max_px = std::max(group.max_px.value_or(0.0), *deviation.px);
    group.contacts += deviation.contacts;
    if (deviation.rest_shift_px) {
      ++group.settled;
      group.rest_shift_px = std::max(group.rest_shift_px.value_or(0.0), *deviation.rest_shift_px);
    }
  }
  return group;
}

Json group_json(const DifferenceGroup& group) {
  std::vector<std::string> paths;
  for (const ScenarioVerdict* const scenario : group.scenarios) paths.push_back(scenario->path);
  std::ranges::sort(paths);
  return Json::Object{{"operation", name_of(group.cause.kind)},
                      {"detail", group.cause.detail},
                      {"scenarios", Json::Array(paths.begin(), paths.end())},
                      {"class", name_of(group.difference)},
                      {"max_px", or_null(group.max_px)},
                      {"contacts_moved", group.contacts.total()},
                      {"rest_shift_px", or_null(group.rest_shift_px)}};
}

std::string consequence_sentence(const DifferenceGroup& group) {
  if (is_non_finite(group)) return "A run ends with its first row that is not finite, and is not blessed.";
  std::string text = fmt::format("{} (class {}): ", class_text(group), name_of(group.difference));
  const bool is_known = std::ranges::all_of(
      group.scenarios, [](const ScenarioVerdict* scenario) { return scenario->deviation().px.has_value(); });
  if (group.max_px)
    text += (*group.max_px > 0.0 ? fmt::format("at most {} apart", px_text(*group.max_px))
                                 : "no position differs") +
            (is_known ? ", " : " where the rows are known, ");
  return text + contacts_text(group.contacts) + rest_text(group) + ".";
}

std::vector<Paragraph> difference_paragraphs(const std::vector<DifferenceGroup>& groups,
                                             const std::vector<std::string>& cores, std::size_t checked) {
  std::vector<Paragraph> paragraphs;
  const auto first_finite = std::ranges::find_if_not(groups, is_non_finite);
  for (auto group = groups.begin(); group != first_finite; ++group)
    paragraphs.push_back(paragraph_of(*group, checked));
  for (const std::string& core : cores)
    if (!core.empty()) paragraphs.push_back(paragraph_of(core));
  for (auto group = first_finite; group != groups.end(); ++group)
    paragraphs.push_back(paragraph_of(*group, checked));
  return paragraphs;
}

}  // namespace hyrax
