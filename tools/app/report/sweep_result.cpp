#include "sim/core/core.h"
#include "sim/ensemble/member_numbers.h"
#include "sim/replay/fingerprint.h"
#include "sim/scenario/frame_clock.h"
#include "sim/trajectory/physics_model.h"
#include "sim/trajectory/state_hash.h"
#include "tools/app/report/report_page.h"
#include "tools/app/sweep/member_result.h"
#include "tools/files/scenario_writer.h"
#include "tools/files/sweep_reader.h"
#include "tools/report/wasm/scenario_record.h"
#include "tools/run_core/run_core.h"
#include "tools/store/ensemble_file.h"

namespace hyrax {
namespace {

// A varied number of each member: of a seed both halves.
std::vector<double> values_of(const Sweep& sweep, std::size_t key, const std::vector<double>& members) {
  std::vector<double> values;
  for (const double member : members) {
    const SweepNumber value = value_of(sweep, key, static_cast<std::int64_t>(member));
    if (const auto* const seed = std::get_if<std::uint64_t>(&value)) {
      values.push_back(static_cast<double>(*seed >> 32));
      values.push_back(static_cast<double>(*seed & 0xFFFFFFFFu));
    } else {
      values.push_back(as_double(value));
    }
  }
  return values;
}

// The sample's members as the page plays and shows them: the base as its core reads it and as text, what each
// varied number is and where, and the results that differ.
Json members_json(const Core& core, const std::string& path, const EnsembleReader& reader, const Sweep& sweep,
                  const std::vector<MemberNumbers>& numbers) {
  std::vector<double> members;
  for (std::int64_t row = 0; row < reader.rows(); row += rows_between_samples(reader))
    members.push_back(static_cast<double>(reader.head().part.member(row)));
  Json::Array inputs, results;
  for (std::size_t key = 0; key < sweep.vary.size(); ++key)
    inputs.push_back(Json::Object{
        {"name", sweep.vary[key].pointer},
        {"place", static_cast<std::int64_t>(place_in_record(sweep.base, sweep.vary[key].pointer))},
        {"is_seed", sweep.vary[key].kind == ScenarioNumberKind::seed},
        {"is_grid", std::holds_alternative<GridAxis>(sweep.vary[key].variation)},
        {"is_choice", std::holds_alternative<ChoiceDraw>(sweep.vary[key].variation)},
        {"values", doubles_json(values_of(sweep, key, members))}});
  for (const MemberNumbers& each : numbers)
    if (each.is_result() && each.known() > 0 && !each.is_constant())
      results.push_back(Json::Object{
          {"name", each.name()}, {"unit", each.unit()}, {"values", doubles_json(each.sample())}});
  return Json::Object{{"core_fingerprint", hex(fingerprint_of(core))},
                      {"parameters", parameters_json(run_core(core, path, sweep.base))},
                      {"record", doubles_json(record_of(sweep.base))},
                      {"scenario", scenario_file_text(sweep.base)},
                      {"events", inputs_json(inputs_of(sweep.base, step_count(sweep.base)))},
                      {"count", reader.rows()},
                      {"members", doubles_json(members)},
                      {"inputs", std::move(inputs)},
                      {"results", std::move(results)}};
}

}  // namespace

ShownResult sweep_result(const Core& core, const std::string& path) {
  const EnsembleReader reader(path);
  const Sweep sweep = parse_sweep(reader.head().sweep_text, path, SweepCheck::first_member).sweep;
  const std::vector<MemberNumbers> numbers = member_numbers(reader);
  ShownResult result = member_result(reader, numbers, sweep.base.name, "fling");
  const std::string& computed_by = reader.head().core;
  const bool is_own = computed_by == core.record.checksum();
  if (!is_own)
    result.verdict.text.emplace_back(
        computed_by.empty() ? "No member is replayed: the file does not name the core that computed it."
                            : "No member is replayed: another core than this program's computed them.");
  const bool is_replayed = is_own && is_core_of_page(core);
  if (is_own && is_paper_model(core.name) && !is_replayed)
    result.verdict.text.emplace_back("No member is replayed: the page has another core than this program.");
  if (is_replayed) result.members = members_json(core, path, reader, sweep, numbers);
  return result;
}

}  // namespace hyrax
