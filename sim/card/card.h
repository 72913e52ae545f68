// The card of a candidate core: what it would change, each line a measurement with its interval.
#pragma once

#include <array>
#include <cstdint>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "sim/card/compared_core.h"
#include "sim/card/core_run.h"
#include "sim/cause/header_change.h"
#include "sim/reference/model.h"
#include "sim/result/estimate.h"
#include "sim/result/figure.h"
#include "sim/result/result.h"
#include "sim/study/methods/cost.h"
#include "sim/study/study.h"

namespace hyrax {

/// Before and after: of the base, of the candidate.
template <class Value>
struct BeforeAfter {
  Value before{};
  Value after{};
};

using ComparedCores = BeforeAfter<ComparedCore>;

/// What is measured of both cores, of the base first.
template <class Measure>
[[nodiscard]] auto of_both(const ComparedCores& cores, const Measure& measure) {
  return BeforeAfter<decltype(measure(cores.before))>{measure(cores.before), measure(cores.after)};
}

struct CardRequest {
  /// All scenarios, their paths relative to the library's folder. Those in its folder `recorded` were
  /// recorded by hand, of those in `hard` hard cases are made.
  std::vector<NamedScenario> library = {};
  std::uint64_t seed = 1;  ///< Of the random flings and runs.
  std::int64_t flings = 1000;
  NanosecondClock now_ns = {};
  BeforeAfter<std::string> rows_hash = {};  ///< Of each core (hyrax::rows_hash), found by another process.
  StepProof proof = {};                     ///< Of the candidate's traced step against the base's.
  std::vector<HeaderChange> changes = {};   ///< From the base's header to the candidate's.
};

enum class StepStatus : std::uint8_t { proved_equal, changed, not_proved };
inline constexpr std::array<std::string_view, 3> kStepStatusNames = {"proved_equal", "changed", "not_proved"};

/// What the traced steps say, and whether any row that was played differs.
struct StepLine {
  StepStatus status = StepStatus::not_proved;
  std::string why = {};  ///< Nothing is proved; empty where both steps are complete and bits differ.
  std::vector<HeaderChange> changes = {};
};

/// Energy of 1 px of height by the paper's gravity.
inline constexpr double kHeight_px2_per_s2 = Model{}.gravity_px_per_s2;

/// How many scenarios have which class of difference.
struct ClassCounts {
  std::int64_t same_bits = 0;
  std::array<std::int64_t, kDifferenceClasses.size()> of_class{};  ///< In the order of kDifferenceClasses.

  void add(const RunChange& change) {
    ++(change.difference ? of_class[static_cast<std::size_t>(*change.difference)] : same_bits);
  }
  [[nodiscard]] std::int64_t of(DifferenceClass difference) const {
    return of_class[static_cast<std::size_t>(difference)];
  }
  [[nodiscard]] std::int64_t total() const {
    return std::accumulate(of_class.begin(), of_class.end(), same_bits);
  }
};

/// A scenario of the library that differs.
struct ScenarioChange {
  std::string path;
  RunChange change;
};

struct LibraryLine {
  ClassCounts classes = {};
  std::vector<ScenarioChange> changed;  ///< In the library's order.
  std::int64_t cut = 0;                 ///< Scenarios compared in their first kCoreRunRowsMax rows only.
};

struct ContactLine {
  std::int64_t scenarios = 0;  ///< Of the library, with other contacts.
  std::int64_t moved = 0;
  std::int64_t only_before = 0;
  std::int64_t only_after = 0;
  BeforeAfter<std::int64_t> contacts = {};  ///< In the whole library.
};

using Bands = BeforeAfter<std::optional<Band>>;

/// Random flings at 60 Hz: x, y anywhere in the window, vx -2000 .. 2000, vy -2000 .. 500 px/s, 20 s.
struct FlingLine {
  ClassCounts classes = {};
  Share changed_contacts = {};
  BeforeAfter<std::int64_t> settled = {};
  std::int64_t no_longer_settle = 0;  ///< They settle with the base alone.
  std::optional<Band> shift_px;       ///< Of x, signed: candidate minus base, where both settle.
  std::optional<Band> distance_px;    ///< Distance of the two places.
  double distance_max_px = 0.0;
  std::vector<double> distances_px;  ///< All of them.
  std::optional<Figure> farthest;    ///< Both paths of the fling of distance_max_px, if that is not 0.
};

/// Where the first kDisplayFlings of the flings land on displays of 24 to 1000 Hz: largest minus smallest x.
struct DisplayLine {
  std::int64_t flings = 0;
  double distance_max_px = 0.0;  ///< Between the places of both cores on the same display.
  Bands spread_px = {};          ///< Of the flings that settle on all with both cores.
  BeforeAfter<std::vector<double>> spreads_px = {};  ///< All of them.
};

/// How far a sprite still moves up and down in the 20th second after it was dropped from 100 px, on each of
/// the displays (kLandingRates_hz).
struct RestLine {
  BeforeAfter<std::vector<double>> moved_px = {};
};

/// What changes the energy of a fling. In flight: the run minus the exact flight of the paper's laws from the
/// same start, summed over its flight arcs (sim/reference, ArcErrors::energy_drift_end_px2_per_s2). At walls,
/// until it settles: over each step that touched one, the row minus the exact flight of the paper's laws from
/// the row before, which follows from rows alone, whatever the core does inside its step.
enum class EnergyCause : std::uint8_t {
  drift,    ///< In flight.
  lift,     ///< Height: back to the wall.
  bounce,   ///< Speed across the walls that were touched.
  friction  ///< Speed along them.
};
inline constexpr std::size_t kEnergyCauseCount = 4;

/// Cost of a step in pairs of samples, base and candidate one after the other in changing order.
struct CostLine {
  BeforeAfter<Band> step_ns = {};
  Band ratio = {};  ///< Candidate / base, of each pair.
};

/// Invariants of one kind (InvariantText::is_general) in hard cases and random runs.
struct InvariantLine {
  BeforeAfter<std::int64_t> cases = {};   ///< Hard cases that break one, expected failures left out.
  BeforeAfter<Share> random_runs = {};    ///< Random runs (sim/search) that do.
  std::vector<std::string> newly_broken;  ///< "CASE: INVARIANT", held by the base or expected to fail there.
  std::vector<std::string> mended;        ///< Fails with the base alone.
};

/// Hard cases of `study hard-cases`, that of the long run left out, and random runs.
struct HardCaseLine {
  std::int64_t cases = 0;        ///< 0 without scenarios to make them from.
  std::int64_t other_cases = 0;  ///< With other bits.
  Share other_random_runs = {};  ///< Likewise.
  InvariantLine general = {};
  InvariantLine listing = {};
};

struct ChangedClaim {
  std::string id;
  BeforeAfter<std::string> verdict = {};
  BeforeAfter<double> number = {};
  std::string unit;
};

struct ClaimLine {
  std::int64_t claims = 0;
  std::vector<ChangedClaim> changed;      ///< With another verdict; both cores were measured.
  std::vector<std::string> not_measured;  ///< With one of the cores alone.
  std::int64_t other_numbers = 0;         ///< Same verdict, other measured value; timings left out.
};

struct Card {
  std::uint64_t seed = 1;
  std::int64_t flings = 0;
  std::int64_t scenarios = 0;
  StepLine step = {};
  /// Why invariants and claims were not measured, as "the candidate has no GRAVITY"; empty: they were.
  std::string lacking = {};
  LibraryLine library = {};
  ContactLine contacts = {};
  FlingLine random = {};
  DisplayLine displays = {};
  RestLine rest = {};
  /// By EnergyCause, px^2/s^2; of the flings that stay finite with both cores.
  std::array<Bands, kEnergyCauseCount> energy_px2_per_s2 = {};
  /// Distance from the exact motion of the paper's laws, frames left out, after 1, 2, ... s; of these flings.
  std::vector<Bands> exact_px = {};
  CostLine cost = {};
  HardCaseLine hard_cases = {};
  ClaimLine claims = {};
  std::int64_t recordings = 0;  ///< Of the scenarios.

  /// Recordings that end elsewhere: more than half a pixel away.
  [[nodiscard]] std::vector<ScenarioChange> moved_recordings() const;
  /// Whether any row of a scenario, fling, hard case or random run differs.
  [[nodiscard]] bool has_other_bits() const {
    return !library.changed.empty() || random.classes.same_bits < flings || hard_cases.other_cases > 0 ||
           hard_cases.other_random_runs.count > 0;
  }
};

/// Sets the card's lines of random flings, of their energy and of exact motion.
/// ERRORS: CoreRefused where the candidate plays the flings differently a second time.
void measure_flings(const ComparedCores& cores, Card& card);

inline constexpr std::int64_t kDisplayFlings = 200;
[[nodiscard]] DisplayLine measure_displays(const ComparedCores& cores, std::uint64_t seed,
                                           std::int64_t flings);
[[nodiscard]] RestLine measure_rest(const ComparedCores& cores);
[[nodiscard]] CostLine measure_cost(const ComparedCores& cores, std::uint64_t seed,
                                    const NanosecondClock& now_ns);

/// Of all rows of the library. ERRORS: CoreRefused.
[[nodiscard]] std::string rows_hash(const ComparedCore& core, const CardRequest& request);

/// Measures both cores. Everything but the cost is the same on every machine.
/// REQUIRES: cores without LibraryCore::defect.
/// ERRORS: CoreRefused.
[[nodiscard]] Card measure_card(const ComparedCores& cores, const CardRequest& request);

/// The largest consequence for a user, one sentence.
[[nodiscard]] std::string consequence_of(const Card& card);

/// Where flings land, over displays and against the exact motion, and their energy by cause; base and
/// candidate in the same plot.
[[nodiscard]] std::vector<Figure> card_figures(const Card& card);

/// The card as a result: its lines as the verdict's one table, whose long name says what was compared; the
/// consequence in brief; the members of its JSON document; as tables what differs, one by one.
[[nodiscard]] Result card_result(const Card& card);

}  // namespace hyrax
