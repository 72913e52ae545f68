#include <cmath>
#include <map>

#include <fmt/format.h>

#include "tools/hyrax-compare/card_output.h"

namespace hyrax {
namespace {

// "35.2 (10 .. 80)"
std::string text_of(const std::optional<Band>& band, double unit = 1.0) {
  if (!band) return "not measured";
  const auto digits = [unit](double value) {
    const double shown = value / unit;
    return std::fabs(shown) >= 100.0 ? fmt::format("{:.0f}", shown) : fmt::format("{:.3g}", shown);
  };
  return fmt::format("{} ({} .. {})", digits(band->median), digits(band->low), digits(band->high));
}
std::string text_of(const BeforeAfter<std::optional<Band>>& pair, const std::string& unit_name,
                    double unit = 1.0) {
  return fmt::format("{} -> {} {}", text_of(pair.before, unit), text_of(pair.after, unit), unit_name);
}

// "12 of 1000, 1.2 % (0.7 .. 2.1 %)"
std::string text_of(const Share& share) {
  return fmt::format("{} of {} (95 %: {:.1f} .. {:.1f} %)", share.count, share.of, 100.0 * share.low(),
                     100.0 * share.high());
}

std::string text_of(const ClassCounts& counts) {
  std::string text = fmt::format("{} of {} the same", counts.same_bits, counts.total());
  for (const DifferenceClass difference : kDifferenceClasses)
    if (counts.of(difference) > 0) text += fmt::format(", {} {}", name_of(difference), counts.of(difference));
  return text;
}

std::string line(std::string_view name, const std::string& text) {
  return fmt::format("  {:<15} {}\n", name, text);
}

// The first few, and how many there are more.
std::string list_text(const std::vector<std::string>& names, std::size_t most = 3) {
  std::string text;
  for (std::size_t index = 0; index < std::min(names.size(), most); ++index)
    text += (index == 0 ? "" : ", ") + names[index];
  if (names.size() > most) text += fmt::format(" and {} more", names.size() - most);
  return text;
}

std::string bits_text(const Card& card) {
  std::string text = line("bits", "scenarios: " + text_of(card.library.classes)) +
                     line("", "random flings: " + text_of(card.random.classes));
  if (card.library.cut > 0)
    text +=
        line("", fmt::format("compared in their first {} rows only: {}", kCoreRunRowsMax, card.library.cut));
  return text;
}

std::string contacts_text(const Card& card) {
  const ContactLine& contacts = card.contacts;
  return line("contacts",
              fmt::format("changed in {} of {} scenarios: {} moved, {} only before, {} only after ({} -> {})",
                          contacts.scenarios, card.scenarios, contacts.moved, contacts.only_before,
                          contacts.only_after, contacts.contacts.before, contacts.contacts.after)) +
         line("", "changed in random flings: " + text_of(card.random.changed_contacts));
}

std::string landing_text(const Card& card) {
  const FlingLine& flings = card.random;
  std::string text = line(
      "landing", fmt::format("shift in x {} px, distance {} px, largest {:.3g} px", text_of(flings.shift_px),
                             text_of(flings.distance_px), flings.distance_max_px));
  text += line("", fmt::format("of {} random flings at 60 Hz settle: {} -> {}", card.flings,
                               flings.settled.before, flings.settled.after));
  return text;
}

// As height.
std::string energy_text(const EnergyLine& energy) {
  constexpr double kHeight_px = 1200.0;  // The paper's gravity: energy of 1 px of height, in px2/s2.
  return line("energy", "as height, in flight: " + text_of(energy.drift_px2_per_s2, "px", kHeight_px)) +
         line("", "at walls, by lift: " + text_of(energy.lift_px2_per_s2, "px", kHeight_px)) +
         line("", "by bounces: " + text_of(energy.bounce_px2_per_s2, "px", kHeight_px)) +
         line("", "by friction: " + text_of(energy.friction_px2_per_s2, "px", kHeight_px));
}

std::string exact_text(const Card& card) {
  std::string text;
  for (const ExactLine& exact : card.exact)
    text += line(text.empty() ? "exact motion" : "",
                 fmt::format("after {:.0f} s at 60 Hz: {}", exact.t_s, text_of(exact.distance_px, "px")));
  return text;
}

// "velocity 9, position 3" of "CASE: INVARIANT".
std::string invariants_text(const std::vector<std::string>& broken) {
  std::map<std::string, int> counts;
  for (const std::string& name : broken) ++counts[name.substr(name.rfind(' ') + 1)];
  std::vector<std::string> parts;
  for (const auto& [invariant, count] : counts) parts.push_back(fmt::format("{} {}", invariant, count));
  return list_text(parts, parts.size());
}

std::string hard_cases_text(const Card& card) {
  if (!card.hard_cases) return line("invariants", "not measured: no scenarios in a folder named hard");
  const HardCaseLine& hard = *card.hard_cases;
  std::string text = line("invariants", fmt::format("broken in {} hard cases: {} -> {}", hard.cases,
                                                    hard.broken.before, hard.broken.after));
  if (!hard.newly_broken.empty()) text += line("", "newly broken: " + invariants_text(hard.newly_broken));
  if (!hard.mended.empty()) text += line("", "no longer broken: " + invariants_text(hard.mended));
  return text + line("", fmt::format("in random runs: {} -> {}", text_of(hard.random_runs.before),
                                     text_of(hard.random_runs.after)));
}

std::string claims_text(const Card& card) {
  const ClaimLine& claims = card.claims;
  std::vector<std::string> changed;
  for (const ChangedClaim& claim : claims.changed)
    changed.push_back(fmt::format("{} {} -> {}", claim.id, claim.verdict.before, claim.verdict.after));
  std::string text = line("paper's claims", fmt::format("{} of {} change, {} more with another number",
                                                        changed.size(), claims.claims, claims.other_numbers));
  for (std::size_t index = 0; index < std::min<std::size_t>(changed.size(), 4); ++index)
    text += line("", changed[index]);
  if (changed.size() > 4) text += line("", fmt::format("and {} more", changed.size() - 4));
  return text;
}

// "fling" of "folder/fling.json".
std::string stem(const std::string& path) {
  const std::size_t begin = path.rfind('/') + 1;
  return path.substr(begin, path.rfind('.') - begin);
}

std::string recordings_text(const Card& card) {
  if (!card.recordings) return line("recordings", "not measured: no scenarios in a folder named recorded");
  std::vector<std::string> moved;
  for (const MovedRecording& recording : card.recordings->moved)
    moved.push_back(fmt::format("{} {:.3g} px", stem(recording.path), recording.px));
  std::string text =
      line("recordings", fmt::format("{} of {} end elsewhere", moved.size(), card.recordings->recordings));
  if (!moved.empty()) text += line("", list_text(moved, 2));
  return text;
}

}  // namespace

std::string card_text(const Card& card, const CardTitle& title) {
  return fmt::format(
             "{} against {}\n  {} scenarios, {} random flings (seed {}); median (10 .. 90 %), before -> "
             "after\n",
             title.candidate, title.base, card.scenarios, card.flings, card.seed) +
         bits_text(card) + contacts_text(card) + landing_text(card) +
         line("displays", fmt::format("a fling's spread over 24 .. 1000 Hz: {}, {} flings",
                                      text_of(card.displays.spread_px, "px"), card.displays.flings)) +
         energy_text(card.energy) + exact_text(card) +
         line("speed", fmt::format("{} -> {} ns a step; ratio {:.3f} ({:.3f} .. {:.3f}), {} pairs",
                                   text_of(card.cost.step_ns.before), text_of(card.cost.step_ns.after),
                                   card.cost.ratio.median, card.cost.ratio.low, card.cost.ratio.high,
                                   card.cost.ratio.samples)) +
         hard_cases_text(card) + claims_text(card) + recordings_text(card) +
         line("consequence", consequence_of(card));
}

}  // namespace hyrax
