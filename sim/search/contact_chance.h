// How likely a run has other contacts if its start is not exactly known.
#pragma once

#include <cstdint>
#include <optional>

#include "sim/core/core.h"
#include "sim/result/estimate.h"
#include "sim/scenario/scenario.h"

namespace hyrax {

/// The start is moved by up to `within_px` in x and in y, each point of that square as likely as any other;
/// the velocity is kept. A contact changes if its wall, its first or its last step does.
///
/// Within the margin (sim/reference/margin.h) no contact changes, so starts are drawn from the square without
/// the margin's: of a share s of the square, a part p of the starts drawn changes contacts, and the chance
/// is s p. Its interval is that of p, by s.
struct ContactChance {
  double within_px = 1.0;
  std::uint64_t seed = 1;
  double drawn_part = 1.0;  ///< s, 0 .. 1.
  Share changed;            ///< Of the starts drawn; of none where the margin holds all of the square.
  std::int64_t steps = 0;   ///< Contacts were compared up to here.

  [[nodiscard]] double chance() const {
    return changed.of == 0
               ? 0.0
               : drawn_part * static_cast<double>(changed.count) / static_cast<double>(changed.of);
  }
  [[nodiscard]] double low() const { return changed.of == 0 ? 0.0 : drawn_part * changed.low(); }
  [[nodiscard]] double high() const { return changed.of == 0 ? 0.0 : drawn_part * changed.high(); }
};

/// Plays the scenario and `starts` others beside it, each for 20,000 steps at most: by then drag has taken
/// all but 2e-9 of a change of the start.
/// @param margin_px half-width of the box around the start within which no contact changes, 0 if not known;
/// nothing: no start changes a contact.
[[nodiscard]] ContactChance contact_chance(const Core& core, const Scenario& scenario,
                                           std::optional<double> margin_px, std::uint64_t seed = 1,
                                           std::int64_t starts = 200);

}  // namespace hyrax
