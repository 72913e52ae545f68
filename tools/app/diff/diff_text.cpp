#include "tools/app/diff/trajectory_diff.h"

#include <fmt/format.h>

#include "sim/result/number_text.h"
#include "tools/app/diff/difference_text.h"

namespace hyrax {
namespace {

std::string change_text(double before, double after) {
  if (before == after) return fmt::format("{:.6g}", before);
  const std::string from = fmt::format("{:.6g}", before);
  const std::string to = fmt::format("{:.6g}", after);
  return from == to ? from : from + " -> " + to;
}

std::string settled_text(const TrajectoryDiff& diff) {
  const auto text = [](const RunEnd& end) {
    if (end.settled_since_s) return fmt::format("settled since {:.6g} s", *end.settled_since_s);
    return std::string(end.has_every_row ? "not settled" : "unknown whether settled");
  };
  const std::string a = text(diff.end_a);
  const std::string b = text(diff.end_b);
  return a == b ? a : a + " -> " + b;
}

std::string end_text(const TrajectoryDiff& diff) {
  const Row& a = diff.end_a.row;
  const Row& b = diff.end_b.row;
  const double shift_px = distance_px(state_of(a), state_of(b));
  const std::string apart = shift_px == 0.0 ? "the same place" : rounded(shift_px, 3) + " px apart";
  return fmt::format("  {:<11}{}: x {}, y {} px; {}\n", diff.comparison.rest_shift_px ? "rest" : "end", apart,
                     change_text(a.x_px, b.x_px), change_text(a.y_px, b.y_px), settled_text(diff));
}

std::string energy_text(const EnergyDifference& energy) {
  if (!energy.largest()) return "  energy     no difference\n";
  const double change = energy.largest()->px2_per_s2;
  return fmt::format("  energy     at most {}{} px²/s², at step {}\n", change > 0.0 ? "+" : "",
                     rounded(change, 3), energy.largest()->step);
}

std::string worst_text(std::string_view field, const WorstDifference& worst) {
  const std::string ulps = ulps_text(ulps_of(field, worst.a, worst.b));
  const std::string distance =
      is_contact_field(field) ? field_value_text(field, worst.a) + " and " + field_value_text(field, worst.b)
                              : fmt::format("{:.6g}{}", worst.abs(), unit_of(field));
  return fmt::format("  worst {:<8}{} at step {}{}\n", field, distance, worst.step,
                     ulps.empty() ? "" : ", " + ulps);
}

}  // namespace

std::string distance_sentence(const TrajectoryDiff& diff) {
  const auto& largest = diff.comparison.largest;
  return largest ? "at most " + rounded(largest->px, 3) + " px apart" : "no position differs";
}

std::string contacts_sentence(const ContactChanges& contacts) {
  if (contacts.is_none()) return contacts.is_cut ? "no recorded contact moved" : "no contact moved";
  return fmt::format("{}{} moved, {} vanished, {} appeared", contacts.is_cut ? "at least " : "",
                     plain_counted(contacts.moved.size(), "contact"), contacts.only_a.size(),
                     contacts.only_b.size());
}

std::string consequence_text(const TrajectoryDiff& diff) {
  const auto& largest = diff.comparison.largest;
  std::string text = fmt::format(
      "  apart      {}", largest ? "at most " + rounded(largest->px, 3) + " px" : distance_sentence(diff));
  if (largest) text += fmt::format(", at step {} ({:.4g} s)", largest->step, diff.largest_at_s.value_or(0.0));
  text += diff.is_by_time ? "; rows of the same time\n" : "\n";
  return text + end_text(diff) +
         fmt::format("  contacts   {}\n", contacts_sentence(diff.comparison.contacts)) +
         (diff.energy ? energy_text(*diff.energy) : "");
}

std::string values_text(const TrajectoryDiff& diff, bool lists_all) {
  const Comparison& comparison = diff.comparison;
  std::string text = difference_text(comparison, lists_all);
  const std::int64_t total_a = diff.end_a.contacts_total, total_b = diff.end_b.contacts_total;
  if (comparison.contacts.is_none() && total_a != total_b)
    text += fmt::format("  total      the numbers of contacts differ: {} and {}\n", total_a, total_b);
  else if (comparison.difference && comparison.shape.empty() && comparison.contacts.is_none() &&
           !comparison.first)
    text += "  hash       the state hashes differ: in rows that are not recorded in both\n";
  for (std::size_t field = 0; field < kRowFields.size(); ++field)
    if (const auto& worst = diff.values.worst()[field]) text += worst_text(kRowFields[field].name, *worst);
  return text;
}

Json diff_json(const TrajectoryDiff& diff) {
  const Comparison& comparison = diff.comparison;
  Json::Object worst;
  for (std::size_t field = 0; field < kRowFields.size(); ++field)
    if (const auto& value = diff.values.worst()[field]) {
      const auto ulps = ulps_of(kRowFields[field].name, value->a, value->b);
      worst.emplace_back(kRowFields[field].name,
                         Json::Object{{"step", value->step}, {"abs", value->abs()}, {"ulps", or_null(ulps)}});
    }
  const auto count = [](const auto& list) { return Json(static_cast<std::int64_t>(list.size())); };
  return Json::Object{{"agree", comparison.agrees},
                      {"class", comparison.difference ? Json(name_of(*comparison.difference)) : Json()},
                      {"first_divergence", divergence_json(comparison.first)},
                      {"worst", std::move(worst)},
                      {"contacts", Json::Object{{"moved", count(comparison.contacts.moved)},
                                                {"only_a", count(comparison.contacts.only_a)},
                                                {"only_b", count(comparison.contacts.only_b)}}}};
}

}  // namespace hyrax
