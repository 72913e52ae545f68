#include <cmath>
#include <map>

#include <fmt/format.h>

#include "sim/card/flings.h"
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

// ", 152 of 200 flings"; empty where the band is of all of them.
std::string size_text(const std::optional<Band>& band, std::int64_t of) {
  return band && band->samples < of ? fmt::format(", {} of {} flings", band->samples, of) : "";
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

// The first few, and how many there are more.
std::string list_text(const std::vector<std::string>& names, std::size_t most = 3) {
  std::string text;
  for (std::size_t index = 0; index < std::min(names.size(), most); ++index)
    text += (index == 0 ? "" : ", ") + names[index];
  if (names.size() > most) text += fmt::format(" and {} more", names.size() - most);
  return text;
}

void add_step(const StepLine& line, CardText& text) {
  constexpr std::size_t kShown = 6;
  if (line.status == StepStatus::proved_equal)
    text.push_back({"step", "same operations on every path: proved"});
  else if (line.status == StepStatus::not_proved)
    text.push_back({"step", "not proved equal: " + line.why});
  else
    text.push_back({"step", line.why.empty() ? "changed" : "changed; not all paths are known: " + line.why});
  if (line.changes.empty() && line.status == StepStatus::changed)
    text.push_back({"", "the header did not change: an included header or a compiler option did"});
  for (std::size_t index = 0; index < std::min(line.changes.size(), kShown); ++index)
    text.push_back({"", change_text(line.changes[index])});
  if (line.changes.size() > kShown)
    text.push_back({"", fmt::format("and {} more", line.changes.size() - kShown)});
}

void add_bits(const Card& card, CardText& text) {
  text.push_back({"bits", "scenarios: " + text_of(card.library.classes)});
  text.push_back({"", "random flings: " + text_of(card.random.classes)});
  const HardCaseLine& hard = card.hard_cases;
  text.push_back(
      {"", fmt::format("hard cases: {} of {} the same, random runs: {} of {}", hard.cases - hard.other_cases,
                       hard.cases, hard.other_random_runs.of - hard.other_random_runs.count,
                       hard.other_random_runs.of)});
  if (card.library.cut > 0)
    text.push_back(
        {"", fmt::format("compared in their first {} rows only: {}", kCoreRunRowsMax, card.library.cut)});
}

void add_contacts(const Card& card, CardText& text) {
  const ContactLine& contacts = card.contacts;
  text.push_back(
      {"contacts",
       fmt::format("changed in {} of {} scenarios: {} moved, {} only before, {} only after ({} -> {})",
                   contacts.scenarios, card.scenarios, contacts.moved, contacts.only_before,
                   contacts.only_after, contacts.contacts.before, contacts.contacts.after)});
  text.push_back({"", "changed in random flings: " + text_of(card.random.changed_contacts)});
}

void add_landing(const Card& card, CardText& text) {
  const FlingLine& flings = card.random;
  text.push_back(
      {"landing", fmt::format("shift in x {} px, distance {} px, largest {:.3g} px{}",
                              text_of(flings.shift_px), text_of(flings.distance_px), flings.distance_max_px,
                              size_text(flings.distance_px, card.flings))});
  text.push_back({"", fmt::format("of {} random flings at 60 Hz settle: {} -> {}", card.flings,
                                  flings.settled.before, flings.settled.after)});
  text.push_back({"displays", fmt::format("a fling's spread over 24 .. 1000 Hz: {}, {} of {} flings",
                                          text_of(card.displays.spread_px, "px"),
                                          card.displays.spreads_px.before.size(), card.displays.flings)});
}

void add_rest(const RestLine& line, CardText& text) {
  const auto moved = [&](std::size_t display) {
    return fmt::format("{:.3g} -> {:.3g} px at {:g} Hz", line.moved_px.before[display],
                       line.moved_px.after[display], kDisplayRates_hz[display]);
  };
  const auto at = [](const auto& list, auto found) { return static_cast<std::size_t>(found - list.begin()); };
  const std::vector<double>& after = line.moved_px.after;
  text.push_back({"rest", fmt::format("a dropped sprite still moves after 19 s by {}, at most by {}",
                                      moved(at(kDisplayRates_hz, std::ranges::find(kDisplayRates_hz, 60.0))),
                                      moved(at(after, std::ranges::max_element(after))))});
}

void add_energy(const Card& card, CardText& text) {
  const EnergyLine& energy = card.energy;
  text.push_back(
      {"energy", "as height, in flight: " + text_of(energy.drift_px2_per_s2, "px", kHeight_px2_per_s2) +
                     size_text(energy.drift_px2_per_s2.after, card.flings)});
  text.push_back({"", "at walls, by lift: " + text_of(energy.lift_px2_per_s2, "px", kHeight_px2_per_s2)});
  text.push_back({"", "by bounces: " + text_of(energy.bounce_px2_per_s2, "px", kHeight_px2_per_s2)});
  text.push_back({"", "by friction: " + text_of(energy.friction_px2_per_s2, "px", kHeight_px2_per_s2)});
}

void add_exact(const Card& card, CardText& text) {
  for (const ExactLine& exact : card.exact)
    text.push_back({&exact == &card.exact.front() ? "exact motion" : "",
                    fmt::format("after {:.0f} s at 60 Hz: {}{}", exact.t_s, text_of(exact.distance_px, "px"),
                                size_text(exact.distance_px.after, card.flings))});
}

void add_speed(const CostLine& cost, CardText& text) {
  text.push_back(
      {"speed", fmt::format("{} -> {} ns a step; ratio {:.3f} ({:.3f} .. {:.3f}), {} pairs",
                            text_of(cost.step_ns.before), text_of(cost.step_ns.after), cost.ratio.median,
                            cost.ratio.low, cost.ratio.high, cost.ratio.samples)});
}

// "velocity 9, position 3" of "CASE: INVARIANT".
std::string invariants_text(const std::vector<std::string>& broken) {
  std::map<std::string, int> counts;
  for (const std::string& name : broken) ++counts[name.substr(name.rfind(' ') + 1)];
  std::vector<std::string> parts;
  for (const auto& [invariant, count] : counts) parts.push_back(fmt::format("{} {}", invariant, count));
  return list_text(parts, parts.size());
}

void add_hard_cases(const Card& card, CardText& text) {
  if (!card.lacking.empty()) return text.push_back({"invariants", "not measured: " + card.lacking});
  const HardCaseLine& hard = card.hard_cases;
  const auto add = [&](const std::string& name, const std::string& kind, const InvariantLine& line) {
    const auto& [before, after] = line.random_runs;
    text.push_back(
        {name, fmt::format("{}: broken in hard cases {} -> {} of {}, in random runs {} -> {}", kind,
                           line.cases.before, line.cases.after, hard.cases, before.count, text_of(after))});
    if (!line.newly_broken.empty())
      text.push_back({"", "newly broken: " + invariants_text(line.newly_broken)});
    if (!line.mended.empty()) text.push_back({"", "no longer broken: " + invariants_text(line.mended)});
  };
  add("invariants", "of any core", hard.general);
  add("", "of the listing", hard.listing);
  if (hard.cases == 0) text.push_back({"", "hard cases: not measured: no scenarios in a folder named hard"});
}

void add_claims(const Card& card, CardText& text) {
  if (!card.lacking.empty()) return text.push_back({"paper's claims", "not measured: " + card.lacking});
  constexpr std::size_t kShown = 4;
  const std::vector<ChangedClaim>& changed = card.claims.changed;
  text.push_back(
      {"paper's claims", fmt::format("{} of {} change, {} more with another number", changed.size(),
                                     card.claims.claims, card.claims.other_numbers)});
  if (const std::vector<std::string>& unmeasured = card.claims.not_measured; !unmeasured.empty())
    text.push_back({"", fmt::format("{} not measured with one of the cores: {}", unmeasured.size(),
                                    list_text(unmeasured))});
  for (std::size_t index = 0; index < std::min(changed.size(), kShown); ++index)
    text.push_back({"", fmt::format("{} {} -> {}", changed[index].id, changed[index].verdict.before,
                                    changed[index].verdict.after)});
  if (changed.size() > kShown) text.push_back({"", fmt::format("and {} more", changed.size() - kShown)});
}

// "fling" of "folder/fling.json".
std::string stem(const std::string& path) {
  const std::size_t begin = path.rfind('/') + 1;
  return path.substr(begin, path.rfind('.') - begin);
}

void add_recordings(const Card& card, CardText& text) {
  if (!card.recordings) {
    text.push_back({"recordings", "not measured: no scenarios in a folder named recorded"});
    return;
  }
  std::vector<std::string> moved;
  for (const MovedRecording& recording : card.recordings->moved)
    moved.push_back(fmt::format("{} {:.3g} px", stem(recording.path), recording.px));
  text.push_back(
      {"recordings", fmt::format("{} of {} end elsewhere", moved.size(), card.recordings->recordings)});
  if (!moved.empty()) text.push_back({"", list_text(moved, 2)});
}

}  // namespace

std::string compared_text(const Card& card) {
  return fmt::format("{} scenarios, {} random flings (seed {}); median (10 .. 90 %), before -> after",
                     card.scenarios, card.flings, card.seed);
}

CardText card_lines(const Card& card) {
  CardText text;
  add_step(card.step, text);
  add_bits(card, text);
  add_contacts(card, text);
  add_landing(card, text);
  add_rest(card.rest, text);
  add_energy(card, text);
  add_exact(card, text);
  add_speed(card.cost, text);
  add_hard_cases(card, text);
  add_claims(card, text);
  add_recordings(card, text);
  return text;
}

std::string card_text(const Card& card, const CardTitle& title) {
  std::string text = fmt::format("{} against {}\n  {}\n", title.candidate, title.base, compared_text(card));
  CardText lines = card_lines(card);
  lines.push_back({"consequence", consequence_of(card)});
  for (const CardLine& line : lines) text += fmt::format("  {:<15} {}\n", line.name, line.text);
  return text;
}

}  // namespace hyrax
