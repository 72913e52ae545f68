#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "sim/card/card.h"
#include "sim/result/number_text.h"

namespace hyrax {
namespace {

// What does not end well at all comes first.
std::string breakdown(const Card& card) {
  std::int64_t non_finite = 0, restless = 0;
  for (const ScenarioChange& changed : card.library.changed) {
    if (changed.change.became_non_finite) ++non_finite;
    if (changed.change.no_longer_settles) ++restless;
  }
  if (non_finite > 0)
    return fmt::format("The sprite vanishes in {} of {} scenarios: its state is no longer finite.",
                       non_finite, card.scenarios);
  if (const std::int64_t lost = card.random.no_longer_settle; lost > 0)
    return fmt::format("{} of {} flings no longer settle within 20 s.", lost, card.flings);
  if (restless > 0)
    return fmt::format("The sprite no longer settles in {} of {} scenarios.", restless, card.scenarios);
  return "";
}

// The scenario that is farthest from where it was; null: no position differs.
const ScenarioChange* farthest_scenario(const Card& card) {
  const ScenarioChange* farthest = nullptr;
  for (const ScenarioChange& changed : card.library.changed)
    if (changed.change.largest && (!farthest || changed.change.largest->px > farthest->change.largest->px))
      farthest = &changed;
  return farthest;
}

// Where most flings show nothing, what is farthest from where it was. Empty: nothing that can be seen.
std::string visible_sentence(const Card& card) {
  const auto& [before, after] = card.displays.spread_px;
  const std::optional<Band>& landing = card.random.distance_px;
  const double landing_px = landing ? landing->median : 0.0;
  const double display_px = before && after ? std::fabs(after->median - before->median) : 0.0;
  if (landing_px >= display_px && landing_px > RestAnchor::kStill_px)
    return fmt::format("A fling lands {} px from where it did (median; one in ten {} px or more).",
                       rounded(landing_px, 3), rounded(landing->high, 3));
  if (display_px > RestAnchor::kStill_px)
    return fmt::format(
        "The same fling on displays of 24 to 1000 Hz lands {} px apart instead of {} px (median of {}).",
        rounded(after->median, 3), rounded(before->median, 3), after->samples);
  const ScenarioChange* const scenario = farthest_scenario(card);
  if (scenario != nullptr && scenario->change.largest->px > RestAnchor::kStill_px)
    return fmt::format("Most flings look the same; in {} the sprite is up to {} px from where it was.",
                       scenario->path, rounded(scenario->change.largest->px, 3));
  const double fling_px = std::max(card.random.distance_max_px, card.displays.distance_max_px);
  if (fling_px > RestAnchor::kStill_px)
    return fmt::format("Most flings look the same; the farthest of {} lands {} px from where it did.",
                       card.flings, rounded(fling_px, 3));
  return "";
}

// Empty where nothing is newly broken that holds for any core.
std::string broken_sentence(const HardCaseLine& hard) {
  const auto& [cases, runs, newly_broken, mended] = hard.general;
  if (newly_broken.empty()) return "";
  return fmt::format(
      "Invariants of any core break in {} -> {} of {} hard cases and {} -> {} of {} random runs.",
      cases.before, cases.after, hard.cases, runs.before.count, runs.after.count, runs.after.of);
}

// What is left to say where no sprite of a scenario or fling is seen elsewhere.
std::string unseen_sentence(const Card& card) {
  const HardCaseLine& hard = card.hard_cases;
  const ScenarioChange* const scenario = farthest_scenario(card);
  const double far_px = std::max({scenario != nullptr ? scenario->change.largest->px : 0.0,
                                  card.random.distance_max_px, card.displays.distance_max_px});
  if (far_px > 0.0)
    return fmt::format("None that can be seen: no sprite is more than {} px from where it was.",
                       rounded(far_px, 2));
  if (!card.library.changed.empty() || card.random.classes.same_bits < card.flings)
    return "None that can be seen: only speeds differ.";
  if (hard.other_cases > 0 || hard.other_random_runs.count > 0)
    return fmt::format("None in scenarios and flings; {} of {} hard cases and {} of {} random runs differ.",
                       hard.other_cases, hard.cases, hard.other_random_runs.count, hard.other_random_runs.of);
  const ClaimLine& claims = card.claims;
  if (!claims.changed.empty() || !claims.not_measured.empty() || claims.other_numbers > 0)
    return "None in scenarios, flings, hard cases and random runs; claims of the paper change.";
  return "None: every row has the same bits.";
}

}  // namespace

std::string consequence_of(const Card& card) {
  std::string sentence = breakdown(card);
  if (sentence.empty()) sentence = visible_sentence(card);
  const std::string broken = broken_sentence(card.hard_cases);
  if (sentence.empty()) return broken.empty() ? unseen_sentence(card) : broken;
  return broken.empty() ? sentence : sentence + " " + broken;
}

}  // namespace hyrax
