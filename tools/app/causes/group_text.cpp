#include "tools/app/causes/difference_group.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/result/number_text.h"
#include "tools/app/command_line/print.h"
#include "tools/files/printable.h"

namespace hyrax {
namespace {

constexpr std::size_t kWorstListed = 3;

bool is_non_finite(const DifferenceGroup& group) { return group.cause.kind == CauseKind::non_finite; }

// Three digits say how far; more are in the JSON document.
std::string px_text(double px) { return rounded(px, 3) + " px"; }

std::string contacts_text(std::int64_t contacts, bool is_cut) {
  if (contacts == 0) return is_cut ? "no recorded contact moved" : "no contact moved";
  return fmt::format("{}{} moved", is_cut ? "at least " : "", plain_counted(contacts, "contact"));
}

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

// "6.833 s", of the golden run as in the picture; a run of blocks keeps no times.
std::string time_text(const PairVerdict& scenario) {
  if (!scenario.runs) return "";
  const auto step = static_cast<std::size_t>(scenario.comparison.largest->step);
  const auto& t_s = scenario.runs->golden.rows.t_s;
  return step < t_s.size() ? fmt::format(", {:.4g} s", t_s[step]) : "";
}

std::string distance_text(const PairVerdict& scenario) {
  const auto& largest = scenario.comparison.largest;
  if (!largest) return "no position differs";
  return fmt::format("{} at step {}{}", px_text(largest->px), largest->step, time_text(scenario));
}

std::string rest_text(const PairVerdict& scenario) {
  const auto& shift_px = scenario.comparison.rest_shift_px;
  if (!shift_px || *shift_px == 0.0 || !scenario.runs) return "";
  const Row& before = scenario.runs->golden.final;
  const Row& after = scenario.runs->fresh.final;
  return fmt::format(", comes to rest at x {:.6g} -> {:.6g}, y {:.6g} -> {:.6g} px", before.x_px, after.x_px,
                     before.y_px, after.y_px);
}

// Where nothing explains a difference, where it begins.
std::string first_text(const DifferenceGroup& group) {
  const auto& first = group.scenarios.front()->comparison.first;
  if (group.cause.kind != CauseKind::unknown || !first) return "";
  return fmt::format("  first   step {}, field {} of {}\n", first->step, first->field,
                     printable(group.scenarios.front()->path));
}

std::string_view lead_of(CauseKind kind) {
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

void print_group(const DifferenceGroup& group, std::size_t checked) {
  const auto [subject, verb, predicate] = cause_sentence(group, checked);
  print_text("{} {}{}\n  {}\n{}", subject, VerdictWord{verb, false}, predicate, consequence_sentence(group),
             worst_text(group));
}

}  // namespace

CauseSentence cause_sentence(const DifferenceGroup& group, std::size_t checked) {
  const std::size_t scenarios = group.scenarios.size();
  CauseSentence sentence{.subject = fmt::format("{} of {}", scenarios, plain_counted(checked, "scenario")),
                         .verb = scenarios == 1 ? "differs" : "differ",
                         .predicate = {}};
  if (is_non_finite(group)) {
    sentence.verb = scenarios == 1 ? "becomes non-finite" : "become non-finite";
    sentence.predicate = fmt::format(": {}{}.", scenarios == 1 ? "" : "in the worst, ", group.cause.detail);
    return sentence;
  }
  sentence.predicate = fmt::format("{}{}.", lead_of(group.cause.kind), group.cause.detail);
  if (group.cause.kind == CauseKind::core)
    sentence.predicate.insert(sentence.predicate.size() - 1,
                              scenarios == 1
                                  ? "; the accepted core gives its golden file"
                                  : fmt::format("; the accepted core gives all {} golden files", scenarios));
  return sentence;
}

std::string consequence_sentence(const DifferenceGroup& group) {
  if (is_non_finite(group)) return "A run ends with its first row that is not finite, and is not blessed.";
  std::string text = fmt::format("{} (class {}): ", class_text(group.difference), name_of(group.difference));
  text += group.max_px > 0.0 ? fmt::format("at most {}", px_text(group.max_px)) : "no position differs";
  text += ", " + contacts_text(group.contacts_moved, group.are_contacts_cut);
  if (group.rest_shift_px)
    text += *group.rest_shift_px == 0.0
                ? ", comes to rest at the same place"
                : fmt::format(", comes to rest up to {} away", px_text(*group.rest_shift_px));
  return text + ".";
}

std::string scenario_consequence(const PairVerdict& scenario) {
  if (const std::string non_finite = non_finite_text(scenario); !non_finite.empty()) return non_finite;
  const ContactChanges& contacts = scenario.comparison.contacts;
  return fmt::format("{}, {}{}", distance_text(scenario), contacts_text(contacts.total(), contacts.is_cut),
                     rest_text(scenario));
}

void print_groups(const std::vector<DifferenceGroup>& groups, const std::vector<const CoreVerdict*>& cores,
                  std::size_t checked) {
  const auto first_finite = std::ranges::find_if_not(groups, is_non_finite);
  for (auto group = groups.begin(); group != first_finite; ++group) print_group(*group, checked);
  for (const CoreVerdict* const core : cores)
    print_text("{}", core_text(*core, cores.size() == 1, groups.empty()));
  for (auto group = first_finite; group != groups.end(); ++group) print_group(*group, checked);
}

}  // namespace hyrax
