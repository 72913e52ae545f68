#include "tools/store/ensemble_file.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "sim/result/table.h"

namespace hyrax {
namespace {

// A value at a place of any alignment.
template <class Value>
void put(std::byte*& to, const Value& value) {
  std::memcpy(to, &value, sizeof value);
  to += sizeof value;
}

template <class Get>
EnsembleColumn member_column(const std::string& name, const std::string& unit, const std::string& long_name,
                             ColumnType type, std::size_t width, Get get) {
  return {"members", name, unit, long_name, type, width, [get](const EnsembleRows& rows, std::byte* to) {
            for (const MemberResult& result : rows.results) put(to, get(result));
          }};
}

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

void add(std::vector<EnsembleColumn>& columns, std::span<const ColumnOf<MemberResult>> described) {
  for (const ColumnOf<MemberResult>& each : described)
    columns.push_back(member_column(each.name, each.unit, each.long_name, ColumnType::real, 1,
                                    [get = each](const MemberResult& r) { return *get.number(r); }));
}

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

EnsembleColumn input_column(const VariedKey& key, std::size_t index) {
  const std::string name = input_name(key.pointer);
  return {"inputs",
          name,
          unit_of(name),
          key.pointer,
          key.kind == ScenarioNumberKind::real      ? ColumnType::real
          : key.kind == ScenarioNumberKind::integer ? ColumnType::integer
                                                    : ColumnType::seed,
          1,
          [index](const EnsembleRows& rows, std::byte* to) {
            for (std::int64_t row = rows.first_row; row < rows.first_row + rows.count; ++row)
              std::visit([&](auto value) { put(to, value); },
                         value_of(rows.sweep, index, rows.part.member(row)));
          }};
}

}  // namespace

std::vector<EnsembleColumn> columns_of(const Sweep& sweep) {
  std::vector<EnsembleColumn> columns;
  if (sweep.keep.has(Keep::final)) add(columns, kFinal);
  if (sweep.keep.has(Keep::contacts))
    columns.push_back(member_column("contacts", "1", "contacts with left, right, top, ground",
                                    ColumnType::integer, 4, [](const MemberResult& r) {
                                      return std::array<std::int64_t, 4>{r.contacts.left, r.contacts.right,
                                                                         r.contacts.top, r.contacts.ground};
                                    }));
  if (sweep.keep.has(Keep::at_rest)) add(columns, kAtRest);
  if (sweep.keep.has(Keep::extremes)) add(columns, kExtremes);
  if (sweep.keep.has(Keep::state_hash))
    columns.push_back(member_column("state_hash", "", "XXH3-128 of all rows", ColumnType::byte,
                                    sizeof(Digest), [](const MemberResult& r) { return r.state_hash; }));
  for (std::size_t key = 0; key < sweep.vary.size(); ++key)
    columns.push_back(input_column(sweep.vary[key], key));
  return columns;
}

hid_t file_type(ColumnType type) {
  return std::array{H5T_IEEE_F64LE, H5T_STD_I64LE, H5T_STD_U64LE, H5T_STD_U8LE}.at(
      static_cast<std::size_t>(type));
}

hid_t memory_type(ColumnType type) {
  return std::array{H5T_NATIVE_DOUBLE, H5T_NATIVE_INT64, H5T_NATIVE_UINT64, H5T_NATIVE_UINT8}.at(
      static_cast<std::size_t>(type));
}

}  // namespace hyrax
