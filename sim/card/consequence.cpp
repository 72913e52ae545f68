#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "sim/card/card.h"

namespace hyrax {
namespace {

// Something that a user would see, and how large it is on the screen.
struct Visible {
  double px = 0.0;
  std::string sentence;
};

std::string landing_sentence(const FlingLine& line) {
  return fmt::format("A fling lands {:.3g} px from where it did (median; one in ten {:.3g} px or more).",
                     line.distance_px->median, line.distance_px->high);
}

std::string display_sentence(const DisplayLine& line) {
  const Band& before = *line.spread_px.before;
  const Band& after = *line.spread_px.after;
  return fmt::format(
      "The same fling on displays of 24 to 1000 Hz lands {:.3g} px apart instead of {:.3g} px (median).",
      after.median, before.median);
}

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
  const std::int64_t lost = card.random.settled.before - card.random.settled.after;
  if (lost > 0) return fmt::format("{} of {} flings no longer settle within 20 s.", lost, card.flings);
  if (restless > 0)
    return fmt::format("The sprite no longer settles in {} of {} scenarios.", restless, card.scenarios);
  return "";
}

}  // namespace

std::string consequence_of(const Card& card) {
  if (std::string sentence = breakdown(card); !sentence.empty()) return sentence;
  std::vector<Visible> visible;
  if (card.random.distance_px)
    visible.push_back({card.random.distance_px->median, landing_sentence(card.random)});
  if (card.displays.spread_px.before && card.displays.spread_px.after)
    visible.push_back(
        {std::fabs(card.displays.spread_px.after->median - card.displays.spread_px.before->median),
         display_sentence(card.displays)});
  const auto widest = std::max_element(visible.begin(), visible.end(),
                                       [](const Visible& a, const Visible& b) { return a.px < b.px; });
  if (widest != visible.end() && widest->px > RestAnchor::kStill_px) return widest->sentence;

  // Nothing that most flings show: the scenario that differs most.
  const ScenarioChange* largest = nullptr;
  double largest_px = 0.0;
  for (const ScenarioChange& changed : card.library.changed)
    if (changed.change.largest && changed.change.largest->px > largest_px) {
      largest = &changed;
      largest_px = changed.change.largest->px;
    }
  if (largest_px > RestAnchor::kStill_px)
    return fmt::format("Most flings look the same; in {} the sprite is up to {:.3g} px from where it was.",
                       largest->path, largest_px);
  const double far_px = std::max(largest_px, card.random.distance_max_px);
  if (far_px > RestAnchor::kStill_px)
    return fmt::format("Most flings look the same; the farthest of {} lands {:.3g} px from where it did.",
                       card.flings, far_px);
  const bool differs = !card.library.changed.empty() || card.random.classes.same_bits < card.flings;
  if (!differs) return "None: every row has the same bits.";
  if (far_px == 0.0) return "None that can be seen: only speeds differ.";
  return fmt::format("None that can be seen: no sprite is more than {:.2g} px from where it was.", far_px);
}

}  // namespace hyrax
