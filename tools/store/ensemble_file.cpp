#include "tools/store/ensemble_file.h"

#include <hdf5_hl.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cerrno>
#include <cstring>
#include <iterator>
#include <optional>

#include <fmt/format.h>

#include "tools/files/failure.h"
#include "tools/files/printable.h"
#include "tools/files/sweep_reader.h"
#include "tools/store/build_facts.h"
#include "tools/store/isolated_read.h"

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

// Calls a function with a varied key's values in its type, and with one that gives what the sweep says of a
// member.
void with_inputs(const SweepPlan& sweep, std::size_t key, Column& column, const auto& take) {
  std::visit(
      [&]<class Value>(Value) {
        take(std::get<std::vector<Value>>(column.values), [&](std::int64_t member) {
          const auto value = std::get<Value>(value_of(sweep, key, member));
          if (column.stored_as != ValueType::float32) return value;
          return static_cast<Value>(static_cast<float>(value));  // As it is played.
        });
      },
      value_of(sweep, key, 0));
}

void write_head(hid_t file, const EnsembleHead& head) {
  h5::write_attribute(file, "format", kEnsembleFormat);
  h5::write_attribute(file, "sweep", head.sweep_text);
  h5::write_attribute(file, "members", head.members);
  h5::write_attribute(file, "physics", head.physics);
  write_core_name(file, head.core);
  if (!head.core_name.empty()) {
    h5::write_attribute(file, "core_name", head.core_name);
    h5::write_attribute(file, "description", head.description);
  }
  if (head.is_part) {
    h5::write_attribute(file, "part", head.part.index);
    h5::write_attribute(file, "parts", head.part.count);
  }
  write_provenance(file);
}

// Nothing if the file is no result file of a sweep.
std::optional<EnsembleHead> read_head(hid_t file) {
  const auto sweep = h5::read_text_attribute(file, "sweep");
  const auto members = h5::read_integer_attribute(file, "members");
  if (h5::read_text_attribute(file, "format") != kEnsembleFormat || !sweep || !members) return std::nullopt;
  EnsembleHead head{.sweep_text = *sweep,
                    .members = *members,
                    .part = {},
                    .physics = h5::read_text_attribute(file, "physics").value_or(""),
                    .core = read_core_name(file),
                    .core_name = h5::read_text_attribute(file, "core_name").value_or(""),
                    .description = h5::read_text_attribute(file, "description").value_or("")};
  const auto part = h5::read_integer_attribute(file, "part");
  const auto parts = h5::read_integer_attribute(file, "parts");
  if (part && parts) {
    head.is_part = true;
    head.part = {*part, *parts};
  }
  const bool is_good =
      head.members >= 1 && head.part.count >= 1 && head.part.index >= 0 && head.part.index < head.part.count;
  return is_good ? std::optional(head) : std::nullopt;
}

// A dimension without values, as netCDF marks it: it takes no room in the file.
h5::Handle create_dimension(hid_t file, const char* name, std::size_t length) {
  h5::Handle scale = h5::create_dataset(file, name, H5T_IEEE_F32BE, {length});
  const std::string mark = fmt::format("This is a netCDF dimension but not a netCDF variable{:10}", length);
  if (scale.is_open() && H5DSset_scale(scale, mark.c_str()) < 0) return {};
  return scale;
}

// The axes of all columns, which netCDF readers such as xarray need to open the groups.
[[nodiscard]] bool attach_axes(hid_t file, const Table& table, const std::vector<h5::Handle>& datasets,
                               hid_t members) {
  bool is_written = true;
  for (std::size_t each = 0; is_written && each < datasets.size(); ++each) {
    const Column& column = table.columns[each];
    is_written = H5DSattach_scale(datasets[each], members, 0) >= 0;
    if (column.width == 1) continue;
    const char* const name = std::holds_alternative<Codes>(column.values) ? "digest_byte" : "wall";
    const h5::Handle values = create_dimension(file, name, column.width);
    is_written = is_written && values.is_open() && H5DSattach_scale(datasets[each], values, 1) >= 0;
  }
  return is_written;
}

// The groups without rows; empty if they could not be written.
std::vector<h5::ColumnWriter> create_groups(hid_t file, const EnsembleHead& head,
                                            const std::vector<Table>& tables) {
  const auto rows = static_cast<hsize_t>(head.part.rows(head.members));
  const h5::Handle members = create_dimension(file, "member", rows);
  std::vector<h5::ColumnWriter> writers;
  for (const Table& table : tables) {
    const h5::Handle group = h5::create_group(file, table.name.c_str());
    h5::ColumnWriter& writer = writers.emplace_back(h5::create_columns(group, table.columns, rows));
    if (!members.is_open() || !group.is_open() || !writer.finish(table.columns, nullptr) ||
        !attach_axes(file, table, writer.datasets(), members))
      return {};
  }
  return writers;
}

// The datasets of each table; empty if one is missing or has another extent.
std::vector<std::vector<h5::Handle>> open_tables(hid_t file, const std::vector<Table>& tables,
                                                 std::int64_t rows) {
  std::vector<std::vector<h5::Handle>> datasets;
  for (const Table& table : tables) {
    const h5::Handle group(H5Gopen2(file, table.name.c_str(), H5P_DEFAULT), H5Gclose);
    datasets.push_back(h5::open_columns(group, table.columns, static_cast<hsize_t>(rows)));
    if (datasets.back().size() != table.columns.size()) return {};
  }
  return datasets;
}

}  // namespace

Table members_table(const KeepSet& keep) {
  constexpr std::span<const MemberResult> kNone;
  Table table{.name = "members"};
  const auto add = [&](Keep kept, std::vector<Column> columns) {
    if (keep.has(kept)) std::ranges::move(columns, std::back_inserter(table.columns));
  };
  add(Keep::final, columns_of(kFinal, kNone));
  add(Keep::contacts, {{.name = "contacts",
                        .unit = "1",
                        .long_name = "contacts with left, right, top, ground",
                        .values = std::vector<std::int64_t>(),
                        .width = 4}});
  add(Keep::at_rest, columns_of(kAtRest, kNone));
  add(Keep::extremes, columns_of(kExtremes, kNone));
  add(Keep::state_hash, {{.name = "state_hash",
                          .long_name = "XXH3-128 of all rows",
                          .values = Codes(),
                          .width = sizeof(Digest)}});
  return table;
}

void set_members(const KeepSet& keep, std::span<const MemberResult> results, Table& table) {
  auto column = table.columns.begin();
  const auto set = [&](Keep kept, const auto& described) {
    if (!keep.has(kept)) return;
    for (const auto& each : described) set_values(*column++, each, results);
  };
  set(Keep::final, kFinal);
  if (keep.has(Keep::contacts)) {
    auto& counts = values_as<std::vector<std::int64_t>>(*column++);
    counts.clear();
    for (const MemberResult& result : results)
      for (const Wall wall : kWalls) counts.push_back(result.contacts[wall]);
  }
  set(Keep::at_rest, kAtRest);
  set(Keep::extremes, kExtremes);
  if (keep.has(Keep::state_hash)) {
    auto& bytes = values_as<Codes>(*column++).codes;
    bytes.clear();
    for (const MemberResult& result : results)
      bytes.insert(bytes.end(), result.state_hash.begin(), result.state_hash.end());
  }
}

Table inputs_table(const SweepPlan& sweep) {
  Table table{.name = "inputs"};
  for (std::size_t key = 0; key < sweep.vary.size(); ++key) {
    const std::string& pointer = sweep.vary[key].pointer;
    const std::string name = input_name(pointer);
    table.columns.push_back({.name = name, .unit = unit_of(name), .long_name = pointer, .values = {}});
    std::visit([&]<class Value>(Value) { table.columns.back().values = std::vector<Value>(); },
               value_of(sweep, key, 0));
  }
  return table;
}

void set_inputs(const SweepPlan& sweep, const WorkPart& part, std::int64_t first_row, std::int64_t count,
                Table& table) {
  for (std::size_t key = 0; key < sweep.vary.size(); ++key)
    with_inputs(sweep, key, table.columns[key], [&](auto& values, const auto& input_of) {
      values.clear();
      for (std::int64_t row = first_row; row < first_row + count; ++row)
        values.push_back(input_of(part.member(row)));
    });
}

EnsembleContents paper_contents(const EnsembleHead& head, const std::string& path) {
  if (!head.core_name.empty())
    refuse_input(printable(path + ": is a sweep of the core " + head.core_name +
                           ", which describes itself: " + head.core_name +
                           "-sim joins its parts; no page shows it"));
  const Sweep sweep = parse_sweep(head.sweep_text, path + ": sweep", SweepCheck::first_member).sweep;
  return {sweep, {members_table(sweep.keep), inputs_table(sweep)}};
}

EnsembleWriter::EnsembleWriter(const std::string& path, const EnsembleHead& head,
                               const std::vector<Table>& tables)
    : path_(path), target_(path) {
  constexpr std::uint64_t kNotInMemory = 1 << 30;
  errno = 0;
  file_ = h5::create_file(target_.part_path(), kNotInMemory);
  require_written(file_.is_open(), path_);
  write_head(file_, head);
  groups_ = create_groups(file_, head, tables);
  require_written(!groups_.empty(), path_);
}

void EnsembleWriter::write(const std::vector<Table>& rows, std::int64_t count) {
  assert(rows.size() == groups_.size());
  errno = 0;
  for (std::size_t table = 0; table < rows.size(); ++table)
    require_written(groups_[table].append(rows[table].columns), path_);
  rows_done_ += count;
}

void EnsembleWriter::finish() {
  errno = 0;
  groups_.clear();
  require_written(file_.close() >= 0, path_);
  target_.commit();
}

EnsembleReader::EnsembleReader(const std::string& path, const ReadContents& read_contents) : path_(path) {
  const auto open = [&] {
    file_ = h5::open_file(path);
    const auto head = file_.is_open() ? read_head(file_) : std::nullopt;
    if (!head) refuse_input(path + ": is no result file of a sweep (" + std::string(kEnsembleFormat) + ")");
    head_ = *head;
    if (h5::has_attribute(file_, "rows_done"))
      refuse_input(path +
                   ": is not complete: an older version was stopped while it wrote it; run the sweep again");
    contents_ = read_contents(head_, path);
    datasets_ = open_tables(file_, tables(), rows());
    if (datasets_.empty()) refuse_input(path + ": is damaged: a column is missing, or has another length");
  };
  read_isolated(path, open);
  open();
}

void EnsembleReader::read(std::size_t table, std::size_t column, std::int64_t first_row, std::int64_t count,
                          Column& rows) const {
  if (h5::read_rows(datasets_[table][column], static_cast<hsize_t>(first_row), static_cast<hsize_t>(count),
                    rows) < 0)
    throw Failure(ExitCode::cannot_access, path_ + ": cannot be read: the HDF5 library fails");
  if (tables()[table].name != "inputs") return;
  with_inputs(contents_.plan, column, rows, [&](const auto& values, const auto& input_of) {
    for (std::int64_t row = 0; row < count; ++row) {
      const std::int64_t member = head_.part.member(first_row + row);
      const auto said = input_of(member);
      if (std::memcmp(&values[static_cast<std::size_t>(row)], &said, sizeof said) != 0)
        refuse_input(path_ + ": " +
                     fmt::format("inputs/{}: the input of member {} is not the sweep's: the file was changed",
                                 rows.name, member));
    }
  });
}

}  // namespace hyrax
