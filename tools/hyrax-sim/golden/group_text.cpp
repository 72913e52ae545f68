#include "tools/hyrax-sim/golden/group_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "tools/files/printable.h"
#include "tools/hyrax-sim/command_line/print.h"

namespace hyrax {
namespace {

constexpr std::size_t kWorstListed = 3;

// Three digits say how far; more are in the JSON document. Whole px from 1,000 px on.
std::string px_text(double px) {
  const bool is_long = px >= 1e3 && px < 1e6;
  return is_long ? fmt::format("{:.0f} px", px) : fmt::format("{:.3g} px", px);
}

std::string contacts_text(std::int64_t contacts) {
  if (contacts == 0) return "no contact moved";
  return fmt::format("{} contact{} moved", contacts, contacts == 1 ? "" : "s");
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

// "6.833 s", where the row is kept; a run of blocks keeps no times.
std::string time_text(const DifferingScenario& scenario) {
  if (scenario.runs == nullptr) return "";
  const auto step = static_cast<std::size_t>(scenario.comparison->largest->step);
  const auto& t_s = scenario.runs->fresh.rows.t_s;
  return step < t_s.size() ? fmt::format(", {:.4g} s", t_s[step]) : "";
}

std::string distance_text(const DifferingScenario& scenario) {
  const auto& largest = scenario.comparison->largest;
  if (!largest) return "no position differs";
  return fmt::format("{} at step {}{}", px_text(largest->px), largest->step, time_text(scenario));
}

std::string rest_text(const DifferingScenario& scenario) {
  const auto& shift_px = scenario.comparison->rest_shift_px;
  if (!shift_px || *shift_px == 0.0 || scenario.runs == nullptr) return "";
  const Row& before = scenario.runs->golden.final;
  const Row& after = scenario.runs->fresh.final;
  return fmt::format(", comes to rest at x {:.6g} -> {:.6g}, y {:.6g} -> {:.6g} px", before.x_px, after.x_px,
                     before.y_px, after.y_px);
}

// Where nothing explains a difference, where it begins.
std::string first_text(const DifferenceGroup& group) {
  const auto& first = group.scenarios.front().comparison->first;
  if (group.reproduced() > 0 || !first) return "";
  return fmt::format("  first   step {}, field {} of {}\n", first->step, first->field,
                     printable(group.scenarios.front().path));
}

std::string worst_text(const DifferenceGroup& group) {
  std::string text = first_text(group);
  const std::size_t listed = std::min(group.scenarios.size(), kWorstListed);
  for (std::size_t index = 0; index < listed; ++index)
    text += fmt::format("  {:<8}{}: {}\n", index == 0 ? "worst" : "", printable(group.scenarios[index].path),
                        scenario_consequence(group.scenarios[index]));
  if (group.scenarios.size() > listed)
    text += fmt::format("  {:<8}and {} more\n", "", group.scenarios.size() - listed);
  return text;
}

}  // namespace

CauseSentence cause_sentence(const DifferenceGroup& group, const GroupCounts& counts) {
  const std::size_t scenarios = group.scenarios.size();
  CauseSentence sentence{.subject = fmt::format("{} of {} scenario{}", scenarios, counts.checked,
                                                counts.checked == 1 ? "" : "s"),
                         .verb = scenarios == 1 ? "differs" : "differ",
                         .predicate = {}};
  if (group.reproduced() == 0) {
    sentence.predicate = fmt::format("; cause unknown: {}.", group.cause.detail);
    return sentence;
  }
  const bool is_edit = group.cause.operation == kScenarioCause;
  sentence.predicate =
      fmt::format("{}: {}{} reproduces {} of {}.",
                  counts.groups == 1 && scenarios > 1 ? ", all by one cause" : " by one cause",
                  is_edit ? "the scenario changed since it was blessed: " : "", group.cause.detail,
                  group.reproduced(), scenarios);
  return sentence;
}

std::string consequence_sentence(const DifferenceGroup& group) {
  std::string text = fmt::format("{} (class {}): ", class_text(group.difference), name_of(group.difference));
  text += group.max_px > 0.0 ? fmt::format("at most {}", px_text(group.max_px)) : "no position differs";
  text += ", " + contacts_text(group.contacts_moved);
  if (group.rest_shift_px)
    text += *group.rest_shift_px == 0.0
                ? ", comes to rest at the same place"
                : fmt::format(", comes to rest up to {} away", px_text(*group.rest_shift_px));
  return text + ".";
}

std::string scenario_consequence(const DifferingScenario& scenario) {
  return fmt::format("{}, {}{}", distance_text(scenario),
                     contacts_text(scenario.comparison->contacts.total()), rest_text(scenario));
}

void print_group(const DifferenceGroup& group, const GroupCounts& counts) {
  const auto [subject, verb, predicate] = cause_sentence(group, counts);
  print_text("{} {}{}\n  {}\n{}", subject, VerdictWord{verb, false}, predicate, consequence_sentence(group),
             worst_text(group));
}

}  // namespace hyrax
