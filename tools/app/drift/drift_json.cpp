#include "tools/app/drift/drift.h"

#include "sim/reference/drift_columns.h"
#include "tools/files/table_text.h"

namespace hyrax {
namespace {

// The value of each worst error, or its step: an arc's first_step, a contact's step.
Json worst_json(const DriftSummary& summary, const auto Worst::*member) {
  Json::Object object;
  const auto add = [&](const auto& columns) {
    for (const auto& column : columns)
      if (const auto worst = column.also; worst != nullptr)
        object.emplace_back(key_of(column_of(column, {})),
                            summary.*worst ? Json((*(summary.*worst)).*member) : Json());
  };
  add(kArcColumns);
  add(kReferenceArcColumns);
  add(kImpactColumns);
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
  Json::Array rows;
  for (const auto& row : sensitivity) rows.emplace_back(Json::Array(row.begin(), row.end()));
  return rows;
}

Json whole_json(const WholeOutcome& whole) {
  Json json = json_of(whole_table(whole));
  if (whole.run) json.get<Json::Object>()->emplace_back("reference", "exact fling");
  return json;
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
  Table arcs{.columns = columns_of(kArcColumns, report.run.arcs)};
  for (Column& column : columns_of(kReferenceArcColumns, report.run.arcs))
    arcs.columns.push_back(std::move(column));
  return {
      {"whole", whole_json(report.run.whole)},
      {"whole_why", report.run.whole.run ? Json() : Json(report.run.whole.why_not)},
      {"skipped_arcs", summary.skipped_arcs},
      {"arcs", json_of(arcs)},
      {"contacts", json_of(Table{.columns = columns_of(kImpactColumns, report.run.contacts)})},
      {"sensitivity", sensitivity_json(report.run.margin.sensitivity)},
      {"worst", worst_json(summary, &Worst::value)},
      {"worst_step", worst_json(summary, &Worst::step)},
      {"arcs_measured", summary.arcs},
      {"contacts_measured", summary.contacts},
      {"effective_restitution", restitution_json(summary.effective_restitution)},
      {"margin", margin_json(report.run.margin, report.contact_chance)},
      {"differing_steps", summary.differing_steps},
      {"reference_faults", summary.reference_faults},
      {"first_reference_fault", summary.reference_faults > 0 ? Json(summary.first_reference_fault) : Json()},
      {"non_finite_step", or_null(summary.non_finite_step)},
      {"not_computed", Json::Array(omitted.begin(), omitted.end())},
      {"step_ns", or_null(report.step_ns)},
      {"half_dt", half_dt_json(report.half_dt)}};
}

}  // namespace hyrax
