#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/core/core.h"
#include "sim/ensemble/member_numbers.h"
#include "sim/replay/fingerprint.h"
#include "sim/result/number_text.h"
#include "sim/scenario/frame_clock.h"
#include "sim/trajectory/physics_model.h"
#include "sim/trajectory/state_hash.h"
#include "tools/app/report/report_page.h"
#include "tools/files/scenario_writer.h"
#include "tools/files/sweep_reader.h"
#include "tools/report/wasm/scenario_record.h"
#include "tools/run_core/run_core.h"
#include "tools/store/ensemble_file.h"

namespace hyrax {
namespace {

// Every row is read, or of a very long file every K-th.
std::int64_t rows_between_read(const EnsembleReader& reader) {
  constexpr std::int64_t kReadMax = 100'000'000;
  return reader.rows() <= kReadMax ? 1 : sample_stride(reader.rows());
}

// All numbers of a column: one, or of contacts one a wall.
void add_numbers(std::vector<MemberNumbers>& all, const EnsembleReader& reader, std::size_t table,
                 std::size_t index) {
  const Column& column = reader.tables()[table].columns[index];
  if (std::holds_alternative<Codes>(column.values)) return;
  const bool is_result = reader.tables()[table].name == "members";
  const std::size_t first = all.size();
  const std::int64_t between = rows_between_read(reader);
  for (std::size_t part = 0; part < column.width; ++part)
    all.emplace_back(column.width == 1 ? column.name : column.name + "." + std::string(kWallNames.at(part)),
                     column.unit, column.long_name, is_result, (reader.rows() + between - 1) / between);
  const std::int64_t rows_at_once = between == 1 ? 1 << 16 : 1;
  Column rows = column;
  for (const auto take : {&MemberNumbers::add, &MemberNumbers::bin}) {
    if (take == &MemberNumbers::bin && !is_result) continue;
    for (std::int64_t row = 0; row < reader.rows(); row += std::max(rows_at_once, between)) {
      reader.read(table, index, row, std::min(rows_at_once, reader.rows() - row), rows);
      with_numbers(rows, [&](const auto& values) {
        for (std::size_t value = 0; value < values.size(); ++value)
          (all[first + value % column.width].*take)(static_cast<double>(values[value]));
      });
    }
  }
}

// One of every so many rows is in the samples.
std::int64_t rows_between_samples(const EnsembleReader& reader) {
  const std::int64_t between = rows_between_read(reader);
  return between * sample_stride((reader.rows() + between - 1) / between);
}

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

// Results that are the same in all members within rounding.
std::string constants_text(const std::vector<MemberNumbers>& numbers) {
  std::string text;
  for (const MemberNumbers& each : numbers) {
    if (!each.is_result() || each.known() == 0 || !each.is_constant()) continue;
    const bool is_zero = std::abs(each.mean()) < 1e-9;
    const bool is_rounded = is_zero && (each.largest() != 0.0 || each.smallest() != 0.0);
    text += fmt::format("{}{} {}{}", text.empty() ? "" : ", ", each.name(),
                        is_zero ? "0" : rounded(each.mean(), 6),
                        each.unit() == "1" || each.unit().empty() ? "" : " " + each.unit());
    if (is_rounded) text += " (rounding)";
  }
  return text;
}

std::string count_text(std::int64_t count) { return with_decimals(static_cast<double>(count), 0); }

}  // namespace

ShownResult sweep_result(const Core& core, const std::string& path) {
  const EnsembleReader reader(path);
  const Sweep sweep = parse_sweep(reader.head().sweep_text, path, SweepCheck::first_member).sweep;
  std::vector<MemberNumbers> numbers;
  for (std::size_t table = 0; table < reader.tables().size(); ++table)
    for (std::size_t column = 0; column < reader.tables()[table].columns.size(); ++column)
      add_numbers(numbers, reader, table, column);
  std::string varied;
  for (const VariedKey& key : sweep.vary) varied += (varied.empty() ? "" : ", ") + key.pointer;
  ShownResult result{
      .title = sweep.base.name,
      .subtitle = fmt::format("{} flings that differ in {}", count_text(sweep.members), varied),
      .tables = {member_table(numbers)},
      .figures = member_figures(numbers, reader.rows()),
      .origin = {{"file", path},
                 {"seed of the draws", std::to_string(sweep.seed)},
                 {"sweep", reader.head().sweep_text}}};
  decltype(Verdict::text) text;
  if (reader.head().is_part)
    text.emplace_back(fmt::format("Part {} of {} of the sweep: {} members.", reader.head().part.index,
                                  reader.head().part.count, count_text(reader.rows())));
  if (const std::int64_t between = rows_between_read(reader); between > 1)
    text.emplace_back(fmt::format("All numbers are those of a sample: 1 of every {} of {} members.", between,
                                  count_text(reader.rows())));
  for (const MemberNumbers& each : numbers)
    if (each.name() == "at_rest_since")
      text.emplace_back(fmt::format("{} of {} members have settled by the end.", count_text(each.known()),
                                    count_text(each.known() + each.missing())));
  if (const std::string constants = constants_text(numbers); !constants.empty())
    text.emplace_back("The same in all members: " + constants + ".");
  const std::string& computed_by = reader.head().core;
  const bool is_own = computed_by == core.record.checksum();
  if (!is_own)
    text.emplace_back(computed_by.empty()
                          ? "No member is replayed: the file does not name the core that computed it."
                          : "No member is replayed: another core than this program's computed them.");
  result.verdict.text = std::move(text);
  if (is_own && is_paper_model(core.name)) result.members = members_json(core, path, reader, sweep, numbers);
  return result;
}

}  // namespace hyrax
