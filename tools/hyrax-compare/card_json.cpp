#include "sim/card/flings.h"
#include "tools/files/table_text.h"
#include "tools/hyrax-compare/card_output.h"

namespace hyrax {
namespace {

Json json_of(const Band& band) {
  return Json::Object{
      {"samples", band.samples}, {"median", band.median}, {"p10", band.low}, {"p90", band.high}};
}
Json json_of(const std::optional<Band>& band) { return band ? json_of(*band) : Json(); }
Json json_of(const Share& share) {
  return Json::Object{
      {"count", share.count}, {"of", share.of}, {"low95", share.low()}, {"high95", share.high()}};
}
Json json_of(std::int64_t value) { return value; }
Json json_of(double value) { return value; }
Json json_of(const std::string& value) { return value; }

template <class Value>
Json json_of(const BeforeAfter<Value>& pair) {
  return Json::Object{{"before", json_of(pair.before)}, {"after", json_of(pair.after)}};
}

template <class Values, class ToJson>
Json array_of(const Values& values, const ToJson& to_json) {
  Json::Array array;
  for (const auto& value : values) array.push_back(to_json(value));
  return array;
}

Json::Object json_of(const ClassCounts& counts) {
  Json::Object object{{"count", counts.total()}, {"same_bits", counts.same_bits}};
  for (const DifferenceClass difference : kDifferenceClasses)
    object.emplace_back(name_of(difference), counts.of(difference));
  return object;
}

Json json_of(const ScenarioChange& changed) {
  const RunChange& change = changed.change;
  return Json::Object{{"scenario", changed.path},
                      {"class", change.difference ? Json(name_of(*change.difference)) : Json()},
                      {"max_px", change.largest ? change.largest->px : 0.0},
                      {"end_shift_px", change.end_shift_px},
                      {"contacts_before", change.contacts_before},
                      {"contacts_after", change.contacts_after},
                      {"moved", std::ssize(change.contacts.moved)},
                      {"only_before", std::ssize(change.contacts.only_a)},
                      {"only_after", std::ssize(change.contacts.only_b)},
                      {"became_non_finite", change.became_non_finite},
                      {"no_longer_settles", change.no_longer_settles}};
}

Json library_json(const LibraryLine& line) {
  Json::Object object = json_of(line.classes);
  object.emplace_back("cut", line.cut);
  object.emplace_back("changed",
                      array_of(line.changed, [](const ScenarioChange& each) { return json_of(each); }));
  return object;
}

Json contacts_json(const ContactLine& line) {
  return Json::Object{{"scenarios", line.scenarios},
                      {"moved", line.moved},
                      {"only_before", line.only_before},
                      {"only_after", line.only_after},
                      {"contacts", json_of(line.contacts)}};
}

Json flings_json(const FlingLine& line) {
  return Json::Object{
      {"classes", json_of(line.classes)},       {"contacts_changed", json_of(line.changed_contacts)},
      {"settled", json_of(line.settled)},       {"no_longer_settle", line.no_longer_settle},
      {"shift_px", json_of(line.shift_px)},     {"distance_px", json_of(line.distance_px)},
      {"distance_max_px", line.distance_max_px}};
}

Json exact_json(const ExactLine& line) {
  return Json::Object{{"t_s", line.t_s}, {"distance_px", json_of(line.distance_px)}};
}

Json names_json(const std::vector<std::string>& names) {
  return array_of(names, [](const std::string& name) { return Json(name); });
}

Json invariants_json(const InvariantLine& line) {
  return Json::Object{{"cases_broken", json_of(line.cases)},
                      {"random_runs_broken", json_of(line.random_runs)},
                      {"newly_broken", names_json(line.newly_broken)},
                      {"mended", names_json(line.mended)}};
}

Json hard_cases_json(const HardCaseLine& line, bool is_judged) {
  return Json::Object{{"cases", line.cases},
                      {"cases_changed", line.other_cases},
                      {"random_runs_changed", json_of(line.other_random_runs)},
                      {"general", is_judged ? invariants_json(line.general) : Json()},
                      {"listing", is_judged ? invariants_json(line.listing) : Json()}};
}

Json step_json(const StepLine& line) {
  return Json::Object{{"status", kStepStatusNames[static_cast<std::size_t>(line.status)]},
                      {"why", line.why.empty() ? Json() : Json(line.why)},
                      {"changes", json_of(changes_table(line.changes))}};
}

Json claims_json(const ClaimLine& line) {
  return Json::Object{{"claims", line.claims},
                      {"changed", array_of(line.changed,
                                           [](const ChangedClaim& claim) {
                                             return Json(Json::Object{{"claim", claim.id},
                                                                      {"verdict", json_of(claim.verdict)},
                                                                      {"number", json_of(claim.number)},
                                                                      {"unit", claim.unit}});
                                           })},
                      {"not_measured", names_json(line.not_measured)},
                      {"other_numbers", line.other_numbers}};
}

Json recordings_json(const RecordingLine& line) {
  return Json::Object{{"recordings", line.recordings},
                      {"moved", array_of(line.moved, [](const MovedRecording& moved) {
                         return Json(Json::Object{{"scenario", moved.path}, {"px", moved.px}});
                       })}};
}

}  // namespace

Json card_json(const Card& card, const CardTitle& title) {
  const auto number = [](double value) { return Json(value); };
  return Json::Object{
      {"candidate", title.candidate},
      {"base", title.base},
      {"seed", card.seed},
      {"step", step_json(card.step)},
      {"lacking", card.lacking.empty() ? Json() : Json(card.lacking)},
      {"scenarios", library_json(card.library)},
      {"contacts", contacts_json(card.contacts)},
      {"flings", flings_json(card.random)},
      {"displays",
       Json::Object{{"flings", card.displays.flings}, {"spread_px", json_of(card.displays.spread_px)}}},
      {"rest",
       Json::Object{{"rate_hz", array_of(kDisplayRates_hz, number)},
                    {"moved_px", Json::Object{{"before", array_of(card.rest.moved_px.before, number)},
                                              {"after", array_of(card.rest.moved_px.after, number)}}}}},
      {"energy", Json::Object{{"drift_px2_per_s2", json_of(card.energy.drift_px2_per_s2)},
                              {"lift_px2_per_s2", json_of(card.energy.lift_px2_per_s2)},
                              {"bounce_px2_per_s2", json_of(card.energy.bounce_px2_per_s2)},
                              {"friction_px2_per_s2", json_of(card.energy.friction_px2_per_s2)}}},
      {"exact", array_of(card.exact, exact_json)},
      {"cost", Json::Object{{"step_ns", json_of(card.cost.step_ns)}, {"ratio", json_of(card.cost.ratio)}}},
      {"hard_cases", hard_cases_json(card.hard_cases, card.lacking.empty())},
      {"claims", card.lacking.empty() ? claims_json(card.claims) : Json()},
      {"recordings", card.recordings ? recordings_json(*card.recordings) : Json()},
      {"consequence", consequence_of(card)}};
}

}  // namespace hyrax
