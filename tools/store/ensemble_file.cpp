#include "tools/store/ensemble_file.h"

#include <hdf5_hl.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cerrno>
#include <optional>
#include <span>

#include <fmt/format.h>

#include "tools/files/atomic_file.h"
#include "tools/files/failure.h"
#include "tools/files/sweep_reader.h"
#include "tools/store/isolated_read.h"
#include "tools/store/provenance.h"

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

// A varied key in rows of a part: a column of the group /inputs.
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

constexpr const char* kRowsDone = "rows_done";

void write_head(hid_t file, const EnsembleHead& head) {
  h5::write_attribute(file, "format", kEnsembleFormat);
  h5::write_attribute(file, "sweep", head.sweep_text);
  h5::write_attribute(file, "members", head.members);
  h5::write_attribute(file, "physics", head.physics);
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
                    .physics = h5::read_text_attribute(file, "physics").value_or("")};
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

[[nodiscard]] bool write_empty(hid_t file, const EnsembleHead& head, const Sweep& sweep) {
  h5::write_attribute(file, kRowsDone, std::int64_t{0});
  write_head(file, head);
  const auto rows = static_cast<hsize_t>(head.part.rows(head.members));
  const h5::Handle members = create_dimension(file, "member", rows);
  for (const Table& table : ensemble_tables(sweep, head.part, 0, {})) {
    const h5::Handle group = h5::create_group(file, table.name.c_str());
    h5::ColumnWriter writer(h5::create_columns(group, table.columns, rows), 0);
    if (!group.is_open() || !writer.finish(table.columns, nullptr) ||
        !attach_axes(file, table, writer.datasets(), members))
      return false;
  }
  return members.is_open();
}

// The datasets of each table; empty if one is missing or has another shape.
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

std::span<const std::byte> bytes_of(const Column& column) {
  std::span<const std::byte> bytes;
  with_numbers(column, [&](const auto& values) { bytes = std::as_bytes(std::span(values)); });
  return bytes;
}

}  // namespace

std::vector<Table> ensemble_tables(const Sweep& sweep, const WorkPart& part, std::int64_t first_row,
                                   std::span<const MemberResult> results) {
  Table inputs{.name = "inputs"};
  for (std::size_t key = 0; key < sweep.vary.size(); ++key)
    inputs.columns.push_back(
        input_column(sweep, key, part, first_row, static_cast<std::int64_t>(results.size())));
  return {members_table(sweep.keep, results), std::move(inputs)};
}

void create_ensemble(const std::string& path, const std::string& result, const EnsembleHead& head,
                     const Sweep& sweep) {
  constexpr std::uint64_t kNotInMemory = 1 << 30;
  errno = 0;
  h5::Handle file = h5::create_file(path, kNotInMemory);
  const bool is_written = file.is_open() && write_empty(file, head, sweep);
  if (file.close() < 0 || !is_written) fail_to_write(result, errno == 0 ? EIO : errno);
  trust_own_file(path);
}

EnsembleWriter::EnsembleWriter(const std::string& path, const std::string& result, const EnsembleHead& head,
                               const Sweep& sweep)
    : result_(result) {
  read_isolated(path, [&] { open(path, head, sweep); });
  open(path, head, sweep);
}

void EnsembleWriter::open(const std::string& path, const EnsembleHead& head, const Sweep& sweep) {
  file_ = h5::open_file_to_write(path);
  const auto found = file_.is_open() ? read_head(file_) : std::nullopt;
  if (!found) refuse_input(path + ": is no sweep's file that can be continued; `--force` starts over");
  if (*found != head)
    refuse_input(path + ": is of another sweep, part or physics model; `--force` starts over");
  const std::int64_t rows = head.part.rows(head.members);
  auto datasets = open_tables(file_, ensemble_tables(sweep, head.part, 0, {}), rows);
  done_ = h5::Handle(H5Aopen(file_, kRowsDone, H5P_DEFAULT), H5Aclose);
  rows_done_ = h5::read_integer_attribute(file_, kRowsDone).value_or(done_.is_open() ? -1 : rows);
  if (rows_done_ < 0 || rows_done_ > rows || datasets.empty())
    refuse_input(path + ": is damaged; `--force` starts over");
  groups_.clear();
  for (std::vector<h5::Handle>& each : datasets)
    groups_.emplace_back(std::move(each), static_cast<hsize_t>(rows_done_));
}

// The rows are in the file before it says so.
void EnsembleWriter::write(const std::vector<Table>& rows) {
  assert(rows.size() == groups_.size());
  errno = 0;
  for (std::size_t table = 0; table < rows.size(); ++table)
    if (!groups_[table].append(rows[table].columns)) fail();
  rows_done_ += static_cast<std::int64_t>(row_count(rows.front()));
  if (H5Fflush(file_, H5F_SCOPE_GLOBAL) < 0 || H5Awrite(done_, H5T_NATIVE_INT64, &rows_done_) < 0 ||
      H5Fflush(file_, H5F_SCOPE_GLOBAL) < 0)
    fail();
}

void EnsembleWriter::finish() {
  errno = 0;
  groups_.clear();
  if (done_.is_open() && (done_.close() < 0 || H5Adelete(file_, kRowsDone) < 0)) fail();
  if (file_.close() < 0) fail();
}

void EnsembleWriter::fail() const { fail_to_write(result_, errno == 0 ? EIO : errno); }

EnsembleReader::EnsembleReader(const std::string& path) : path_(path) {
  const auto open = [&] {
    file_ = h5::open_file(path);
    const auto head = file_.is_open() ? read_head(file_) : std::nullopt;
    if (!head) refuse_input(path + ": is no result file of a sweep (" + std::string(kEnsembleFormat) + ")");
    head_ = *head;
    if (const auto done = h5::read_integer_attribute(file_, kRowsDone))
      refuse_input(path + ": " +
                   fmt::format("is not complete: {} of {} members are done; continue it with --resume", *done,
                               rows()));
    sweep_ = parse_sweep(head_.sweep_text, path + ": sweep", SweepCheck::first_member).sweep;
    tables_ = ensemble_tables(sweep_, head_.part, 0, {});
    datasets_ = open_tables(file_, tables_, rows());
    if (datasets_.empty()) refuse_input(path + ": is damaged: a column is missing, or has another length");
  };
  read_isolated(path, open);
  open();
}

Column EnsembleReader::read(std::size_t table, std::size_t column, std::int64_t first_row,
                            std::int64_t count) const {
  Column read = tables_[table].columns[column];
  if (h5::read_rows(datasets_[table][column], static_cast<hsize_t>(first_row), static_cast<hsize_t>(count),
                    read) < 0)
    throw Failure(ExitCode::cannot_access, path_ + ": cannot be read: the HDF5 library fails");
  if (tables_[table].name != "inputs") return read;
  const Column said = input_column(sweep_, column, head_.part, first_row, count);
  const auto bytes = bytes_of(read);
  const auto differing = std::ranges::mismatch(bytes, bytes_of(said)).in1 - bytes.begin();
  if (const auto row = differing / static_cast<std::ptrdiff_t>(sizeof(double)); row < count)
    refuse_input(path_ + ": " +
                 fmt::format("inputs/{}: the input of member {} is not the sweep's: the file was changed",
                             read.name, head_.part.member(first_row + row)));
  return read;
}

}  // namespace hyrax
