#include "tools/hyrax-sim/drift/drift.h"

namespace hyrax {
namespace {

Json energy_parts_json(const ArcEnergyParts& parts) {
  return Json::Object{{"gravity", parts.gravity}, {"drag", parts.drag}};
}

Json energy_parts_json(const ContactEnergyParts& parts) {
  return Json::Object{{"flight", parts.flight},
                      {"lift", parts.lift},
                      {"bounce", parts.bounce},
                      {"friction", parts.friction},
                      {"rest", parts.rest}};
}

Json arc_json(const ArcErrors& arc) {
  return Json::Object{{"first_step", arc.first_step},
                      {"last_step", arc.last_step},
                      {"duration_s", arc.duration_s},
                      {"ended_by", kArcEndNames[static_cast<std::size_t>(arc.ended_by)]},
                      {"implementation_px", arc.implementation_px},
                      {"truncation_px", arc.truncation_px},
                      {"model_px", arc.model_px},
                      {"energy_drift_rel_max", arc.energy_drift_rel_max},
                      {"energy_drift_rel_end", arc.energy_drift_rel_end},
                      {"energy_drift_slope_px_per_s", or_null(arc.energy_drift_slope_px_per_s)},
                      {"energy_drift_slope_per_s", or_null(arc.energy_drift_slope_per_s)},
                      {"energy_drift_max", arc.energy_drift_max_px2_per_s2},
                      {"energy_drift_end", arc.energy_drift_end_px2_per_s2},
                      {"exact_law_px", arc.exact_law_px},
                      {"energy_parts", energy_parts_json(arc.energy_parts)},
                      {"gsl_vs_closed_px", or_null(arc.gsl_vs_closed_px)}};
}

Json contact_json(const ImpactErrors& contact) {
  return Json::Object{{"step", contact.step},
                      {"wall", kWallNames[wall_index(contact.wall)]},
                      {"time_error_s", or_null(contact.time_error_s)},
                      {"overshoot_px", contact.overshoot_px},
                      {"energy_jump_rel", contact.energy_jump_rel},
                      {"effective_restitution", or_null(contact.effective_restitution)},
                      {"energy_parts", energy_parts_json(contact.energy_parts)}};
}

template <class Value, class Write>
Json list_of(const std::vector<Value>& values, const Write& write) {
  Json::Array list;
  for (const Value& value : values) list.push_back(write(value));
  return list;
}

struct WorstKey {
  const char* key;
  std::optional<Worst> DriftSummary::*worst;
};
constexpr WorstKey kWorstKeys[] = {
    {"implementation_px", &DriftSummary::implementation_px},
    {"truncation_px", &DriftSummary::truncation_px},
    {"model_px", &DriftSummary::model_px},
    {"exact_law_px", &DriftSummary::exact_law_px},
    {"energy_drift_rel_max", &DriftSummary::energy_drift_rel_max},
    {"energy_drift_slope_px_per_s", &DriftSummary::energy_drift_slope_px_per_s},
    {"energy_drift_slope_per_s", &DriftSummary::energy_drift_slope_per_s},
    {"energy_drift_max", &DriftSummary::energy_drift_max_px2_per_s2},
    {"gsl_vs_closed_px", &DriftSummary::gsl_vs_closed_px},
    {"time_error_s", &DriftSummary::time_error_s},
    {"overshoot_px", &DriftSummary::overshoot_px},
    {"energy_jump_rel", &DriftSummary::energy_jump_rel}};

// The value of each worst error, or its step: an arc's first_step, a contact's step.
Json worst_json(const DriftSummary& summary, const auto Worst::*member) {
  Json::Object object;
  for (const auto& [key, error] : kWorstKeys) {
    const std::optional<Worst>& worst = summary.*error;
    object.emplace_back(key, worst ? Json((*worst).*member) : Json());
  }
  return object;
}

Json restitution_json(const Spread& spread) {
  if (spread.count() == 0) return nullptr;
  return Json::Object{{"median", spread.median()},
                      {"smallest", spread.smallest()},
                      {"largest", spread.largest()},
                      {"contacts", spread.count()}};
}

Json sensitivity_json(const Sensitivity& sensitivity) {
  return list_of(std::vector(sensitivity.begin(), sensitivity.end()),
                 [](const auto& row) { return Json(Json::Array(row.begin(), row.end())); });
}

Json whole_json(const DriftRun& run) {
  if (!run.whole.run) return nullptr;
  const WholeRun& whole = *run.whole.run;
  return Json::Object{{"end_px", whole.end_px},
                      {"max_px", whole.max_px},
                      {"max_px_step", whole.max_px_step},
                      {"energy_end_px", whole.energy_end_px},
                      {"energy_max_px", whole.energy_max_px},
                      {"secular_px_per_s", or_null(run.summary.secular_px_per_s)},
                      {"contacts_differ_from", or_null(whole.contacts_differ_from)},
                      {"reference", "exact fling"}};
}

Json half_dt_json(const HalfDtOutcome& outcome) {
  if (!outcome.half) return nullptr;
  return Json::Object{{"steps", outcome.half->steps},
                      {"step_ns", outcome.half->step_ns},
                      {"worst", worst_json(outcome.half->summary, &Worst::value)}};
}

}  // namespace

Json margin_json(const Margin& margin, const std::optional<ContactChance>& chance) {
  Json::Object object{{"half_width", or_null(margin.half_width)}};
  if (margin.nearest)
    object.emplace_back(
        "nearest_decision",
        Json::Object{{"decision", kDecisionNames[static_cast<std::size_t>(margin.nearest->decision)]},
                     {"step", margin.nearest->step},
                     {"taken", margin.nearest->is_taken}});
  else
    object.emplace_back("nearest_decision", nullptr);
  object.emplace_back("sensitivity", sensitivity_json(margin.sensitivity));
  object.emplace_back("sensitivity_norm", margin.sensitivity_norm);
  if (chance)
    object.emplace_back("contact_change", Json::Object{{"within_px", chance->within_px},
                                                       {"chance", chance->chance()},
                                                       {"low", chance->low()},
                                                       {"high", chance->high()},
                                                       {"drawn_part", chance->drawn_part},
                                                       {"starts", chance->changed.of},
                                                       {"changed", chance->changed.count},
                                                       {"steps", chance->steps},
                                                       {"seed", chance->seed}});
  return object;
}

Json::Object drift_json(const DriftReport& report) {
  const DriftSummary& summary = report.run.summary;
  const std::vector<std::string> omitted = not_computed(report);
  return {
      {"whole", whole_json(report.run)},
      {"whole_why", report.run.whole.run ? Json() : Json(report.run.whole.why_not)},
      {"skipped_arcs", summary.skipped_arcs},
      {"arcs", list_of(report.run.arcs, arc_json)},
      {"contacts", list_of(report.run.contacts, contact_json)},
      {"sensitivity", sensitivity_json(report.run.margin.sensitivity)},
      {"worst", worst_json(summary, &Worst::value)},
      {"worst_step", worst_json(summary, &Worst::step)},
      {"arcs_measured", summary.arcs},
      {"contacts_measured", summary.contacts},
      {"effective_restitution", restitution_json(summary.effective_restitution)},
      {"margin", margin_json(report.run.margin, report.contact_chance)},
      {"steps_astray", summary.differing_steps},
      {"reference_faults", summary.reference_faults},
      {"first_reference_fault", summary.reference_faults > 0 ? Json(summary.first_reference_fault) : Json()},
      {"non_finite_step", or_null(summary.non_finite_step)},
      {"not_computed", Json::Array(omitted.begin(), omitted.end())},
      {"step_ns", or_null(report.step_ns)},
      {"half_dt", half_dt_json(report.half_dt)}};
}

}  // namespace hyrax
