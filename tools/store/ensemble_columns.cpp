#include "tools/store/ensemble_file.h"

#include <algorithm>
#include <array>

namespace hyrax {
namespace {

constexpr ColumnOf<MemberResult> kFinal[] = {
    {"x", "px", "final x", [](const MemberResult& r) { return r.final.x_px; }},
    {"y", "px", "final y", [](const MemberResult& r) { return r.final.y_px; }},
    {"vx", "px/s", "final vx", [](const MemberResult& r) { return r.final.vx_px_per_s; }},
    {"vy", "px/s", "final vy", [](const MemberResult& r) { return r.final.vy_px_per_s; }},
};
constexpr ColumnOf<MemberResult> kAtRest[] = {
    {"at_rest_since", "s", "since when it has settled; NaN: it has not", &MemberResult::at_rest_since_s},
};
constexpr ColumnOf<MemberResult> kExtremes[] = {
    {"x_min", "px", "smallest x of all rows", &MemberResult::x_min_px},
    {"x_max", "px", "largest x of all rows", &MemberResult::x_max_px},
    {"y_min", "px", "smallest y of all rows", &MemberResult::y_min_px},
    {"y_max", "px", "largest y of all rows", &MemberResult::y_max_px},
    {"speed_max", "px/s", "largest speed of all rows", &MemberResult::speed_max_px_per_s},
};

// "/start/x_px" is start.x_px.
std::string input_name(const std::string& pointer) {
  std::string name = pointer.substr(1);
  std::replace(name.begin(), name.end(), '/', '.');
  return name;
}

std::string unit_of(std::string_view name) {
  constexpr std::array<std::array<std::string_view, 2>, 4> kUnits = {
      {{"_px_per_s", "px/s"}, {"_px", "px"}, {"_hz", "Hz"}, {"_s", "s"}}};
  for (const auto& [suffix, unit] : kUnits)
    if (name.ends_with(suffix)) return std::string(unit);
  return "";
}

Table members_table(const KeepSet& keep, std::span<const MemberResult> results) {
  Table table{.name = "members"};
  const auto add = [&](Keep kept, const auto& described) {
    if (!keep.has(kept)) return;
    for (Column& column : columns_of(described, results)) table.columns.push_back(std::move(column));
  };
  add(Keep::final, kFinal);
  if (keep.has(Keep::contacts)) {
    std::vector<std::int64_t> counts;
    for (const MemberResult& result : results)
      for (const std::int64_t WallCounts::*wall :
           {&WallCounts::left, &WallCounts::right, &WallCounts::top, &WallCounts::ground})
        counts.push_back(result.contacts.*wall);
    table.columns.push_back({.name = "contacts",
                             .unit = "1",
                             .long_name = "contacts with left, right, top, ground",
                             .values = std::move(counts),
                             .width = 4});
  }
  add(Keep::at_rest, kAtRest);
  add(Keep::extremes, kExtremes);
  if (keep.has(Keep::state_hash)) {
    Codes bytes;
    for (const MemberResult& result : results)
      bytes.codes.insert(bytes.codes.end(), result.state_hash.begin(), result.state_hash.end());
    table.columns.push_back({.name = "state_hash",
                             .long_name = "XXH3-128 of all rows",
                             .values = std::move(bytes),
                             .width = sizeof(Digest)});
  }
  return table;
}

}  // namespace

Column input_column(const Sweep& sweep, std::size_t key, const WorkPart& part, std::int64_t first_row,
                    std::int64_t count) {
  const std::string& pointer = sweep.vary[key].pointer;
  const std::string name = input_name(pointer);
  Column column{.name = name, .unit = unit_of(name), .long_name = pointer, .values = {}};
  std::visit(
      [&]<class Value>(Value) {
        std::vector<Value> values;
        values.reserve(static_cast<std::size_t>(count));
        for (std::int64_t row = first_row; row < first_row + count; ++row)
          values.push_back(std::get<Value>(value_of(sweep, key, part.member(row))));
        column.values = std::move(values);
      },
      value_of(sweep, key, 0));
  return column;
}

std::vector<Table> ensemble_tables(const Sweep& sweep, const WorkPart& part, std::int64_t first_row,
                                   std::span<const MemberResult> results) {
  Table inputs{.name = "inputs"};
  for (std::size_t key = 0; key < sweep.vary.size(); ++key)
    inputs.columns.push_back(
        input_column(sweep, key, part, first_row, static_cast<std::int64_t>(results.size())));
  return {members_table(sweep.keep, results), std::move(inputs)};
}

}  // namespace hyrax
