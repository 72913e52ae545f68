#include "tools/app/causes/difference_group.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/result/number_text.h"
#include "tools/app/comparison/comparison_text.h"
#include "tools/files/printable.h"

namespace hyrax {
namespace {

constexpr std::size_t kWorstListed = 3;

bool is_non_finite(const DifferenceGroup& group) { return group.cause.kind == CauseKind::non_finite; }

// Three digits say how far; more are in the JSON document.
std::string px_text(double px) { return rounded(px, 3) + " px"; }

std::string_view class_text(DifferenceClass difference) {
  switch (difference) {
    case DifferenceClass::rounding:
      return "Rounding only";
    case DifferenceClass::values:
      return "Values differ, contacts do not";
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
  const auto& first = group.scenarios.front()->comparison.first;
  if (group.cause.kind != CauseKind::unknown || !first) return "";
  return fmt::format("  first   step {}, field {} of {}\n", first->step, first->field,
                     printable(group.scenarios.front()->path));
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
                        scenario_consequence(*group.scenarios[index]));
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
  } else if (group.cause.kind == CauseKind::core) {
    predicate += scenarios == 1 ? "; the accepted core gives its golden file"
                                : fmt::format("; the accepted core gives all {} golden files", scenarios);
  }
  predicate += ".";
  return paragraph;
}

Paragraph paragraph_of(const CoreVerdict& core, bool is_alone, bool scenarios_agree) {
  const std::string text = core_text(core, is_alone, scenarios_agree);
  const std::size_t end = std::min(text.find('\n'), text.size());
  return {.subject = text.substr(0, end), .lines = text.substr(std::min(end + 1, text.size()))};
}

}  // namespace

std::string consequence_sentence(const DifferenceGroup& group) {
  if (is_non_finite(group)) return "A run ends with its first row that is not finite, and is not blessed.";
  std::string text = fmt::format("{} (class {}): ", class_text(group.difference), name_of(group.difference));
  text += group.max_px > 0.0 ? fmt::format("at most {} apart", px_text(group.max_px)) : "no position differs";
  return text + ", " + contacts_text(group.contacts) + rest_text(group) + ".";
}

std::string scenario_consequence(const PairVerdict& scenario) {
  const std::string non_finite = non_finite_text(scenario);
  return non_finite.empty() ? comparison_sentence(scenario.comparison) : non_finite;
}

std::vector<Paragraph> difference_paragraphs(const std::vector<DifferenceGroup>& groups,
                                             const std::vector<const CoreVerdict*>& cores,
                                             std::size_t checked) {
  std::vector<Paragraph> paragraphs;
  const auto first_finite = std::ranges::find_if_not(groups, is_non_finite);
  for (auto group = groups.begin(); group != first_finite; ++group)
    paragraphs.push_back(paragraph_of(*group, checked));
  for (const CoreVerdict* const core : cores)
    if (core->status != CoreStatus::accepted)
      paragraphs.push_back(paragraph_of(*core, cores.size() == 1, groups.empty()));
  for (auto group = first_finite; group != groups.end(); ++group)
    paragraphs.push_back(paragraph_of(*group, checked));
  return paragraphs;
}

}  // namespace hyrax
