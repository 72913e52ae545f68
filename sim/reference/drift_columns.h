// What drift measures, each quantity once: its name, unit, description and value, its key in JSON, and how
// text shows it. Tables, text, JSON and HDF5 are made of these lists by code that knows no quantity.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim/reference/drift.h"
#include "sim/reference/whole_run.h"
#include "sim/result/table.h"

namespace hyrax {

/// How the text of drift shows a column, and the largest of its values in magnitude.
struct DriftShown {
  constexpr DriftShown(const char* text_head = nullptr, std::optional<Worst> DriftSummary::*largest = nullptr,
                       const char* text_unit = nullptr, double text_scale = 1.0)
      : head(text_head), worst(largest), unit(text_unit), scale(text_scale) {}
  const char* head;  ///< Null: not in the tables of the text.
  std::optional<Worst> DriftSummary::*worst;
  const char* unit;  ///< Null: the column's.
  double scale;      ///< That unit in one of the column's.
};
template <class Record>
using DriftColumn = ColumnOf<Record, DriftShown>;

inline constexpr DriftColumn<ArcErrors> kArcColumns[] = {
    {"first_step", "", "row that the arc begins with", &ArcErrors::first_step, "", DriftShown("from")},
    {"last_step", "", "row that the arc ends with", &ArcErrors::last_step, "", DriftShown("to")},
    {"duration", "s", "time from the first row to the last", &ArcErrors::duration_s, "", DriftShown("time")},
    {"ended_by", "", "what ended the arc",
     DriftColumn<ArcErrors>::Code{[](const ArcErrors& a) { return static_cast<std::uint8_t>(a.ended_by); },
                                  {kArcEndNames}},
     "", DriftShown("ended by")},
    {"implementation", "px", "largest distance from the discrete closed form", &ArcErrors::implementation_px,
     "", DriftShown("implem.", &DriftSummary::implementation_px)},
    {"truncation", "px", "largest distance from the matched ODE", &ArcErrors::truncation_px, "",
     DriftShown("trunc.", &DriftSummary::truncation_px)},
    {"model", "px", "largest distance from the ODE with the drag rate of 60 Hz", &ArcErrors::model_px, "",
     DriftShown("model", &DriftSummary::model_px)},
    {"energy_drift_rel_max", "1",
     "energy_drift_max / largest energy of the matched ODE, that of 1 px of height at least",
     &ArcErrors::energy_drift_rel_max, "",
     DriftShown("drift", &DriftSummary::energy_drift_rel_max, "%", 100.0)},
    {"energy_drift_rel_end", "1",
     "energy_drift_end / largest energy of the matched ODE, that of 1 px of height at least",
     &ArcErrors::energy_drift_rel_end},
    {"energy_drift_slope_height", "px/s", "slope of a line fitted to the energy drift as height",
     &ArcErrors::energy_drift_slope_px_per_s, "energy_drift_slope_px_per_s",
     DriftShown("slope", &DriftSummary::energy_drift_slope_px_per_s)},
    {"energy_drift_slope", "1/s", "slope of a line fitted to the relative energy drift",
     &ArcErrors::energy_drift_slope_per_s, "energy_drift_slope_per_s",
     DriftShown("slope", &DriftSummary::energy_drift_slope_per_s, "%/s", 100.0)},
    {"energy_drift_max", "px2/s2", "largest energy drift in magnitude",
     &ArcErrors::energy_drift_max_px2_per_s2, "energy_drift_max",
     DriftShown(nullptr, &DriftSummary::energy_drift_max_px2_per_s2)},
    {"energy_drift_end", "px2/s2", "energy of the run minus the matched ODE's at the last row",
     &ArcErrors::energy_drift_end_px2_per_s2, "energy_drift_end"},
    {"exact_law", "px", "largest distance from the flow of the step's exact law", &ArcErrors::exact_law_px,
     "", DriftShown(nullptr, &DriftSummary::exact_law_px)},
    {"implementation_speed", "px/s", "largest difference of velocity from the discrete closed form",
     &ArcErrors::implementation_px_per_s, "-"},
    {"truncation_speed", "px/s", "largest difference of velocity from the matched ODE",
     &ArcErrors::truncation_px_per_s, "-"},
    {"exact_law_speed", "px/s", "largest difference of velocity from the flow of the step's exact law",
     &ArcErrors::exact_law_px_per_s, "-"},
    {"energy_by_gravity", "px2/s2", "part of energy_drift_end by the discretisation of gravity",
     [](const ArcErrors& a) { return a.energy_parts.gravity; }, "energy_parts/gravity"},
    {"energy_by_drag", "px2/s2", "part of energy_drift_end by drag along another path",
     [](const ArcErrors& a) { return a.energy_parts.drag; }, "energy_parts/drag"},
};

/// Of the reference itself, or of what it was checked by.
inline constexpr DriftColumn<ArcErrors> kReferenceArcColumns[] = {
    {"energy_largest", "px2/s2", "largest specific energy of the matched ODE",
     &ArcErrors::energy_largest_px2_per_s2, "-"},
    {"coordinate_largest", "px", "largest coordinate of run and matched ODE",
     &ArcErrors::coordinate_largest_px, "-"},
    {"gsl_vs_closed", "px", "largest distance between GSL's solution and the closed form",
     &ArcErrors::gsl_vs_closed_px, "", DriftShown("off GSL", &DriftSummary::gsl_vs_closed_px)},
};

inline constexpr DriftColumn<ImpactErrors> kImpactColumns[] = {
    {"step", "", "clamped row", &ImpactErrors::step, "", DriftShown("contact")},
    {"wall", "", "wall: 1 left, 2 right, 4 top, 8 ground",
     DriftColumn<ImpactErrors>::Code{[](const ImpactErrors& c) { return static_cast<std::uint8_t>(c.wall); },
                                     {kWallNames, true}},
     "", DriftShown("wall")},
    {"time_error", "s", "time of the clamped row minus the true impact's", &ImpactErrors::time_error_s, "",
     DriftShown("time error", &DriftSummary::time_error_s, "ms", 1e3)},
    {"overshoot", "px", "how far past the wall the unclamped position was", &ImpactErrors::overshoot_px, "",
     DriftShown("overshoot", &DriftSummary::overshoot_px)},
    {"energy_jump_rel", "1",
     "energy change over the clamped step / largest energy of the arc, that of 1 px of height at least",
     &ImpactErrors::energy_jump_rel, "",
     DriftShown("energy jump", &DriftSummary::energy_jump_rel, "%", 100.0)},
    {"effective_restitution", "1", "normal speed after / normal speed at the true impact",
     &ImpactErrors::effective_restitution, "", DriftShown("restitution")},
    {"energy_by_flight", "px2/s2", "energy change of the clamped step by its flight without walls",
     [](const ImpactErrors& c) { return c.energy_parts.flight; }, "energy_parts/flight"},
    {"energy_by_lift", "px2/s2", "by the lift out of the wall",
     [](const ImpactErrors& c) { return c.energy_parts.lift; }, "energy_parts/lift"},
    {"energy_by_bounce", "px2/s2", "by restitution",
     [](const ImpactErrors& c) { return c.energy_parts.bounce; }, "energy_parts/bounce"},
    {"energy_by_friction", "px2/s2", "by the friction of the ground",
     [](const ImpactErrors& c) { return c.energy_parts.friction; }, "energy_parts/friction"},
    {"energy_by_rest", "px2/s2", "by the rest rule",
     [](const ImpactErrors& c) { return c.energy_parts.rest; }, "energy_parts/rest"},
};

inline constexpr DriftColumn<WholeRun> kWholeColumns[] = {
    {"end", "px", "distance from the exact fling in the last row", &WholeRun::end_px},
    {"max", "px", "largest distance from the exact fling", &WholeRun::max_px},
    {"max_step", "", "row of the largest distance", &WholeRun::max_px_step, "max_px_step"},
    {"energy_end", "px", "energy of the run minus the exact fling's in the last row, as height",
     &WholeRun::energy_end_px},
    {"energy_max", "px",
     "largest difference of energies, as height, over rows at which both have had the same contacts",
     &WholeRun::energy_max_px},
    {"energy_phase", "px", "the largest over the other rows", &WholeRun::energy_phase_px},
    {"secular", "px/s", "slope of the energy drift in flight, as height", &WholeRun::secular_px_per_s},
    {"contacts_differ_from", "", "row of the first contact that is not the exact fling's; -1: none",
     &WholeRun::contacts_differ_from},
};

/// Of the document alone.
inline constexpr DriftColumn<WholeRun> kEnclosureColumns[] = {
    {"end_low", "px", "end_px for certain: at least", &WholeRun::end_px_low, "end_px_low"},
    {"end_high", "px", "at most", &WholeRun::end_px_high, "end_px_high"},
    {"max_low", "px", "max_px for certain: at least", &WholeRun::max_px_low, "max_px_low"},
    {"max_high", "px", "at most", &WholeRun::max_px_high, "max_px_high"},
};

inline constexpr ColumnOf<RowErrors> kReferenceRowColumns[] = {
    {"x", "px", "left edge by the matched ODE", &RowErrors::x_px},
    {"y", "px", "top edge by the matched ODE", &RowErrors::y_px},
    {"vx", "px/s", "velocity to the right by the matched ODE", &RowErrors::vx_px_per_s},
    {"vy", "px/s", "velocity downwards by the matched ODE", &RowErrors::vy_px_per_s},
    {"energy", "px2/s2", "specific energy of the matched ODE, 0 at rest on the floor",
     &RowErrors::energy_px2_per_s2},
};

inline constexpr ColumnOf<RowErrors> kDriftRowColumns[] = {
    {"implementation", "px", "distance from the discrete closed form", &RowErrors::implementation_px},
    {"truncation", "px", "distance from the matched ODE", &RowErrors::truncation_px},
    {"model", "px", "distance from the ODE with the drag rate of 60 Hz", &RowErrors::model_px},
    {"energy", "px2/s2", "specific energy of the run, 0 at rest on the floor",
     [](const RowErrors& r) { return r.energy_px2_per_s2 + r.energy_drift_px2_per_s2; }},
    {"energy_drift", "px2/s2", "specific energy of the run minus the matched ODE's",
     &RowErrors::energy_drift_px2_per_s2},
};

/// One row, or none without an exact fling.
[[nodiscard]] inline Table whole_table(const WholeOutcome& whole) {
  const auto runs = whole.run ? std::vector{*whole.run} : std::vector<WholeRun>();
  return {.name = "whole", .columns = columns_of(kWholeColumns, runs), .form = JsonForm::one};
}

}  // namespace hyrax
