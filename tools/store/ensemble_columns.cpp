#include "tools/store/ensemble_file.h"

#include <algorithm>
#include <cstring>

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

template <class Get>
EnsembleColumn real_column(const std::string& name, const std::string& unit, const std::string& long_name,
                           Get get) {
  return member_column(name, unit, long_name, ColumnType::real, 1, get);
}

using EnsembleColumns = std::vector<EnsembleColumn>;

void add_final(EnsembleColumns& columns) {
  columns.push_back(real_column("x", "px", "final x", [](const MemberResult& r) { return r.final.x_px; }));
  columns.push_back(real_column("y", "px", "final y", [](const MemberResult& r) { return r.final.y_px; }));
  columns.push_back(
      real_column("vx", "px/s", "final vx", [](const MemberResult& r) { return r.final.vx_px_per_s; }));
  columns.push_back(
      real_column("vy", "px/s", "final vy", [](const MemberResult& r) { return r.final.vy_px_per_s; }));
}

void add_contacts(EnsembleColumns& columns) {
  columns.push_back(member_column("contacts", "1", "contacts with left, right, top, ground",
                                  ColumnType::integer, 4, [](const MemberResult& r) {
                                    return std::array<std::int64_t, 4>{r.contacts.left, r.contacts.right,
                                                                       r.contacts.top, r.contacts.ground};
                                  }));
}

void add_extremes(EnsembleColumns& columns) {
  columns.push_back(
      real_column("x_min", "px", "smallest x of all rows", [](const MemberResult& r) { return r.x_min_px; }));
  columns.push_back(
      real_column("x_max", "px", "largest x of all rows", [](const MemberResult& r) { return r.x_max_px; }));
  columns.push_back(
      real_column("y_min", "px", "smallest y of all rows", [](const MemberResult& r) { return r.y_min_px; }));
  columns.push_back(
      real_column("y_max", "px", "largest y of all rows", [](const MemberResult& r) { return r.y_max_px; }));
  columns.push_back(real_column("speed_max", "px/s", "largest speed of all rows",
                                [](const MemberResult& r) { return r.speed_max_px_per_s; }));
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

ColumnType type_of(ScenarioNumberKind kind) {
  switch (kind) {
    case ScenarioNumberKind::real:
      return ColumnType::real;
    case ScenarioNumberKind::integer:
      return ColumnType::integer;
    case ScenarioNumberKind::seed:
      return ColumnType::seed;
  }
  return ColumnType::real;
}

EnsembleColumn input_column(const VariedKey& key, std::size_t index) {
  const std::string name = input_name(key.pointer);
  return {"inputs",
          name,
          unit_of(name),
          key.pointer,
          type_of(key.kind),
          1,
          [index](const EnsembleRows& rows, std::byte* to) {
            for (std::int64_t row = rows.first_row; row < rows.first_row + rows.count; ++row)
              std::visit([&](auto value) { put(to, value); },
                         value_of(rows.sweep, index, rows.part.member(row)));
          }};
}

}  // namespace

std::vector<EnsembleColumn> columns_of(const Sweep& sweep) {
  EnsembleColumns columns;
  if (sweep.keep.has(Keep::final)) add_final(columns);
  if (sweep.keep.has(Keep::contacts)) add_contacts(columns);
  if (sweep.keep.has(Keep::at_rest))
    columns.push_back(real_column("at_rest_since", "s", "since when it has settled; NaN: it has not",
                                  [](const MemberResult& r) { return r.at_rest_since_s; }));
  if (sweep.keep.has(Keep::extremes)) add_extremes(columns);
  if (sweep.keep.has(Keep::state_hash))
    columns.push_back(member_column("state_hash", "", "XXH3-128 of all rows", ColumnType::byte,
                                    sizeof(Digest), [](const MemberResult& r) { return r.state_hash; }));
  for (std::size_t key = 0; key < sweep.vary.size(); ++key)
    columns.push_back(input_column(sweep.vary[key], key));
  return columns;
}

hid_t file_type(ColumnType type) {
  switch (type) {
    case ColumnType::real:
      return H5T_IEEE_F64LE;
    case ColumnType::integer:
      return H5T_STD_I64LE;
    case ColumnType::seed:
      return H5T_STD_U64LE;
    case ColumnType::byte:
      return H5T_STD_U8LE;
  }
  return H5I_INVALID_HID;
}

hid_t memory_type(ColumnType type) {
  switch (type) {
    case ColumnType::real:
      return H5T_NATIVE_DOUBLE;
    case ColumnType::integer:
      return H5T_NATIVE_INT64;
    case ColumnType::seed:
      return H5T_NATIVE_UINT64;
    case ColumnType::byte:
      return H5T_NATIVE_UINT8;
  }
  return H5I_INVALID_HID;
}

}  // namespace hyrax
