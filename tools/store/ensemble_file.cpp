#include "tools/store/ensemble_file.h"

#include <hdf5_hl.h>

#include <cassert>
#include <cerrno>
#include <cstring>

#include <fmt/format.h>

#include "tools/files/atomic_file.h"
#include "tools/files/failure.h"
#include "tools/files/sweep_reader.h"
#include "tools/store/isolated_read.h"
#include "tools/store/provenance.h"

namespace hyrax {
namespace {

constexpr const char* kRowsDone = "rows_done";

[[noreturn]] void refuse(const std::string& path, const std::string& sentence) {
  throw Failure(ExitCode::bad_input, path + ": " + sentence);
}

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

std::vector<hsize_t> shape_of(const EnsembleColumn& column, std::int64_t rows) {
  std::vector<hsize_t> shape{static_cast<hsize_t>(rows)};
  if (column.width > 1) shape.push_back(column.width);
  return shape;
}

// Datasets of all columns; empty if one is missing or has another shape.
std::vector<h5::Handle> open_datasets(hid_t file, const std::vector<EnsembleColumn>& columns,
                                      std::int64_t rows) {
  std::vector<h5::Handle> datasets;
  for (const EnsembleColumn& column : columns) {
    datasets.emplace_back(H5Dopen2(file, column.path().c_str(), H5P_DEFAULT), H5Dclose);
    if (!datasets.back().is_open() || h5::shape_of(datasets.back()) != shape_of(column, rows)) return {};
  }
  return datasets;
}

// A dimension without values, as netCDF marks it: it takes no room in the file.
h5::Handle create_dimension(hid_t file, const char* name, std::size_t length) {
  h5::Handle scale = h5::create_dataset(file, name, H5T_IEEE_F32BE, {length});
  const std::string mark = fmt::format("This is a netCDF dimension but not a netCDF variable{:10}", length);
  if (scale.is_open() && H5DSset_scale(scale, mark.c_str()) < 0) return {};
  return scale;
}

// The axes of all columns, which netCDF readers such as xarray need to open the groups.
[[nodiscard]] bool attach_axes(hid_t file, const std::vector<EnsembleColumn>& columns,
                               const std::vector<h5::Handle>& datasets, std::int64_t rows) {
  const h5::Handle members = create_dimension(file, "member", static_cast<std::size_t>(rows));
  bool is_written = members.is_open();
  for (std::size_t each = 0; is_written && each < columns.size(); ++each) {
    is_written = H5DSattach_scale(datasets[each], members, 0) >= 0;
    if (columns[each].width == 1) continue;
    const char* const name = columns[each].type == ColumnType::byte ? "digest_byte" : "wall";
    const h5::Handle values = create_dimension(file, name, columns[each].width);
    is_written = is_written && values.is_open() && H5DSattach_scale(datasets[each], values, 1) >= 0;
  }
  return is_written;
}

[[nodiscard]] bool write_empty(hid_t file, const EnsembleHead& head, const Sweep& sweep) {
  h5::write_attribute(file, kRowsDone, std::int64_t{0});
  write_head(file, head);
  for (const char* const name : {"members", "inputs"})
    if (!h5::create_group(file, name).is_open()) return false;
  const std::int64_t rows = head.part.rows(head.members);
  const std::vector<EnsembleColumn> columns = columns_of(sweep);
  std::vector<h5::Handle> datasets;
  for (const EnsembleColumn& column : columns) {
    datasets.push_back(h5::create_dataset_in_place(file, column.path().c_str(), file_type(column.type),
                                                   shape_of(column, rows)));
    if (!datasets.back().is_open()) return false;
    if (!column.unit.empty()) h5::write_attribute(datasets.back(), "units", column.unit);
    h5::write_attribute(datasets.back(), "long_name", column.long_name);
  }
  return attach_axes(file, columns, datasets, rows);
}

}  // namespace

void create_ensemble(const std::string& path, const EnsembleHead& head, const Sweep& sweep) {
  constexpr std::uint64_t kNotInMemory = 1 << 30;
  errno = 0;
  h5::Handle file = h5::create_file(path, kNotInMemory);
  const bool is_written = file.is_open() && write_empty(file, head, sweep);
  if (file.close() < 0 || !is_written) fail_to_write(path, errno == 0 ? EIO : errno);
}

EnsembleWriter::EnsembleWriter(const std::string& path, const EnsembleHead& head, const Sweep& sweep)
    : path_(path), columns_(columns_of(sweep)) {
  read_isolated(path_, [&] { open(head); });
  open(head);
}

void EnsembleWriter::open(const EnsembleHead& head) {
  file_ = h5::open_file_to_write(path_);
  const auto found = file_.is_open() ? read_head(file_) : std::nullopt;
  if (!found) refuse(path_, "is no sweep's file that can be continued; `--force` starts over");
  if (*found != head) refuse(path_, "is of another sweep, part or physics model; `--force` starts over");
  const std::int64_t rows = head.part.rows(head.members);
  datasets_ = open_datasets(file_, columns_, rows);
  done_ = h5::Handle(H5Aopen(file_, kRowsDone, H5P_DEFAULT), H5Aclose);
  rows_done_ = h5::read_integer_attribute(file_, kRowsDone).value_or(done_.is_open() ? -1 : rows);
  if (rows_done_ < 0 || rows_done_ > rows || datasets_.size() != columns_.size())
    refuse(path_, "is damaged; `--force` starts over");
}

void EnsembleWriter::write(const EnsembleRows& rows) {
  assert(rows.first_row == rows_done_);
  std::vector<std::vector<std::byte>> columns;
  for (const EnsembleColumn& column : columns_) {
    columns.emplace_back(column.row_bytes() * static_cast<std::size_t>(rows.count));
    column.fill(rows, columns.back().data());
  }
  write(columns, rows.count);
}

// The rows are in the file before it says so.
void EnsembleWriter::write(const std::vector<std::vector<std::byte>>& columns, std::int64_t count) {
  errno = 0;
  for (std::size_t column = 0; column < columns_.size(); ++column)
    if (h5::write_rows(datasets_[column], memory_type(columns_[column].type),
                       static_cast<hsize_t>(rows_done_), static_cast<hsize_t>(count),
                       columns[column].data()) < 0)
      fail();
  rows_done_ += count;
  if (H5Fflush(file_, H5F_SCOPE_GLOBAL) < 0 || H5Awrite(done_, H5T_NATIVE_INT64, &rows_done_) < 0 ||
      H5Fflush(file_, H5F_SCOPE_GLOBAL) < 0)
    fail();
}

void EnsembleWriter::finish() {
  errno = 0;
  datasets_.clear();
  if (done_.is_open() && (done_.close() < 0 || H5Adelete(file_, kRowsDone) < 0)) fail();
  if (file_.close() < 0) fail();
}

void EnsembleWriter::fail() const { fail_to_write(path_, errno == 0 ? EIO : errno); }

EnsembleReader::EnsembleReader(const std::string& path) : path_(path) {
  const auto open = [&] {
    file_ = h5::open_file(path);
    const auto head = file_.is_open() ? read_head(file_) : std::nullopt;
    if (!head) refuse(path, "is no result file of a sweep (" + std::string(kEnsembleFormat) + ")");
    head_ = *head;
    if (const auto done = h5::read_integer_attribute(file_, kRowsDone))
      refuse(path, fmt::format("is not complete: {} of {} members are done; continue it with --resume", *done,
                               rows()));
    sweep_ = parse_sweep(head_.sweep_text, path + ": sweep", SweepCheck::first_member).sweep;
    columns_ = columns_of(sweep_);
    datasets_ = open_datasets(file_, columns_, rows());
    if (datasets_.size() != columns_.size())
      refuse(path, "is damaged: a column is missing, or has another length");
  };
  read_isolated(path, open);
  open();
}

void EnsembleReader::read(std::size_t column, std::int64_t first_row, std::int64_t count,
                          std::byte* to) const {
  const EnsembleColumn& what = columns_[column];
  if (h5::read_rows(datasets_[column], memory_type(what.type), static_cast<hsize_t>(first_row),
                    static_cast<hsize_t>(count), to) < 0)
    throw Failure(ExitCode::cannot_access, path_ + ": cannot be read: the HDF5 library fails");
  if (what.group != "inputs") return;
  std::vector<std::byte> said(static_cast<std::size_t>(count) * what.row_bytes());
  what.fill({sweep_, head_.part, first_row, count, {}}, said.data());
  for (std::int64_t row = 0; row < count; ++row) {
    const std::size_t at = static_cast<std::size_t>(row) * what.row_bytes();
    if (std::memcmp(said.data() + at, to + at, what.row_bytes()) != 0)
      refuse(path_, fmt::format("{}: the input of member {} is not the sweep's: the file was changed",
                                what.path(), head_.part.member(first_row + row)));
  }
}

}  // namespace hyrax
