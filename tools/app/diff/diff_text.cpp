#include "tools/app/diff/trajectory_diff.h"

#include <fmt/format.h>

#include "sim/result/number_text.h"
#include "tools/app/comparison/comparison_text.h"

namespace hyrax {
namespace {

std::string_view meaning(DifferenceClass difference, bool builds_differ) {
  if (difference == DifferenceClass::shape)
    return "not explained by the build: the files are not two intact runs of one scenario with the same "
           "inputs";
  if (!builds_differ) return "not explained by the build: usually the core changed between the runs";
  return "strict builds give the same bits with all build settings: usually one of the two fuses\n"
         "             multiply-adds, or the core changed as well; `hyrax-sim check` with each of the\n"
         "             programs shows which one differs from the golden files";
}

std::string energy_text(const EnergyDifference& energy) {
  if (!energy.largest()) return "no difference";
  const double change = energy.largest()->px2_per_s2;
  return fmt::format("at most {}{} px²/s², at step {}", change > 0.0 ? "+" : "", rounded(change, 3),
                     energy.largest()->step);
}

std::string build_text(const Provenance& a, const Provenance& b,
                       const std::optional<DifferenceClass>& difference) {
  bool builds_differ = false, is_recorded = true;
  std::string changes;
  for (std::size_t index = 0; index < a.size(); ++index) {
    is_recorded = is_recorded && a[index] && b[index];
    if (!a[index] || !b[index] || a[index] == b[index]) continue;
    // The program's version is no setting of its build.
    builds_differ = builds_differ || kProvenanceNames[index] != std::string_view("program");
    changes += fmt::format("             {}: '{}' and '{}'\n", kProvenanceNames[index], *a[index], *b[index]);
  }
  const std::string text = fmt::format("  build settings: {}{}\n{}", builds_differ ? "differ" : "identical",
                                       is_recorded ? "" : " where recorded", changes);
  return difference ? text + comparison_line("meaning", std::string(meaning(*difference, builds_differ)))
                    : text;
}

}  // namespace

std::string diff_text(const TrajectoryDiff& diff, const Provenance& a, const Provenance& b, bool lists_all) {
  const Comparison& comparison = diff.comparison;
  std::string text;
  if (diff.has_differences()) {
    text = comparison_text(comparison, lists_all);
    if (comparison.contacts.is_none() && diff.contacts_total_a != diff.contacts_total_b)
      text += comparison_line("total", fmt::format("the numbers of contacts differ: {} and {}",
                                                   diff.contacts_total_a, diff.contacts_total_b));
    else if (comparison.difference && comparison.shape.empty() && comparison.contacts.is_none() &&
             !comparison.first)
      text += comparison_line("hash", "the state hashes differ: in rows that are not recorded in both");
    if (diff.energy) text += comparison_line("energy", energy_text(*diff.energy));
    for (std::size_t field = 0; field < kRowFields.size(); ++field)
      if (const auto& worst = diff.values.worst()[field]) text += worst_text(kRowFields[field].name, *worst);
  }
  return comparison.agrees && !lists_all ? text : text + build_text(a, b, comparison.difference);
}

Json diff_json(const TrajectoryDiff& diff) {
  Json::Object worst;
  for (std::size_t field = 0; field < kRowFields.size(); ++field)
    if (const auto& value = diff.values.worst()[field]) {
      const auto ulps = ulps_of(kRowFields[field].name, value->a, value->b);
      worst.emplace_back(kRowFields[field].name,
                         Json::Object{{"step", value->step}, {"abs", value->abs()}, {"ulps", or_null(ulps)}});
    }
  const ContactCounts contacts = diff.comparison.contacts.counts();
  Json::Object document = comparison_json(diff.comparison);
  document.insert(document.begin(), {"agree", diff.comparison.agrees});
  document.emplace_back("worst", std::move(worst));
  document.emplace_back(
      "contacts",
      Json::Object{{"moved", contacts.moved}, {"only_a", contacts.vanished}, {"only_b", contacts.appeared}});
  return document;
}

}  // namespace hyrax
