#include "tools/store/ensemble_file.h"

#include <cassert>
#include <cerrno>
#include <cstdio>

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tools/files/atomic_file.h"
#include "tools/files/failure.h"
#include "tools/files/path.h"
#include "tools/files/sweep_reader.h"
#include "tools/store/isolated_read.h"
#include "tools/store/provenance.h"
#include "tools/store/trajectory_format.h"

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
  write_provenance(file, own_provenance());
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

// The lock tells a writer that another one is at work; it ends with its process.
int lock_file(const std::string& path, const std::string& shown) {
  const int descriptor = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor < 0) fail_to_write(shown, errno);
  struct flock whole {};
  whole.l_type = F_WRLCK;
  whole.l_whence = SEEK_SET;
  if (fcntl(descriptor, F_OFD_SETLK, &whole) == 0 || (errno != EAGAIN && errno != EACCES)) return descriptor;
  close(descriptor);
  throw Failure(ExitCode::cannot_access, path + ": cannot be written: another process is writing it");
}

}  // namespace

std::string partial_path(const std::string& path) { return path + ".partial"; }

EnsembleWriter::EnsembleWriter(const std::string& path, const EnsembleHead& head, const Sweep& sweep,
                               bool resumes)
    : path_(path), partial_path_(partial_path(path)), columns_(columns_of(sweep)) {
  if (is_folder(path)) fail_to_write(path, EISDIR);
  const bool existed = is_there(partial_path_);
  lock_ = lock_file(partial_path_, path);
  take_mode(lock_, path_, S_IRUSR | S_IWUSR);
  try {
    if (!resumes || !existed || !resume(head)) create(head, head.part.rows(head.members));
  } catch (...) {
    close(lock_);
    throw;
  }
}

EnsembleWriter::~EnsembleWriter() { close(lock_); }

void EnsembleWriter::create(const EnsembleHead& head, std::int64_t rows) {
  constexpr std::uint64_t kNotInMemory = 1 << 30;
  errno = 0;
  file_ = h5::create_file(partial_path_, kNotInMemory);
  if (!file_.is_open()) fail();
  write_head(file_, head);
  for (const char* const name : {"members", "inputs"})
    if (!h5::create_group(file_, name).is_open()) fail();
  for (const EnsembleColumn& column : columns_) {
    datasets_.push_back(h5::create_dataset_in_place(file_, column.path().c_str(), file_type(column.type),
                                                    shape_of(column, rows)));
    if (!datasets_.back().is_open()) fail();
    if (!column.unit.empty()) h5::write_attribute(datasets_.back(), "units", column.unit);
    h5::write_attribute(datasets_.back(), "long_name", column.long_name);
  }
  h5::write_attribute(file_, kRowsDone, std::int64_t{0});
  done_ = h5::Handle(H5Aopen(file_, kRowsDone, H5P_DEFAULT), H5Aclose);
  if (!done_.is_open() || H5Fflush(file_, H5F_SCOPE_GLOBAL) < 0) fail();
}

// False if the file was left before anything was done.
bool EnsembleWriter::resume(const EnsembleHead& head) {
  bool is_begun = false;
  const auto open = [&] {
    file_ = h5::open_file_to_write(partial_path_);
    const auto found = file_.is_open() ? read_head(file_) : std::nullopt;
    const auto rows_done = file_.is_open() ? h5::read_integer_attribute(file_, kRowsDone) : std::nullopt;
    is_begun = found && rows_done;
    if (!is_begun) return;
    if (*found != head)
      refuse(partial_path_, "is of another sweep, part or physics model; start over without --resume");
    const std::int64_t rows = head.part.rows(head.members);
    datasets_ = open_datasets(file_, columns_, rows);
    done_ = h5::Handle(H5Aopen(file_, kRowsDone, H5P_DEFAULT), H5Aclose);
    if (*rows_done < 0 || *rows_done > rows || datasets_.size() != columns_.size() || !done_.is_open())
      refuse(partial_path_, "is damaged; start over without --resume");
    rows_done_ = *rows_done;
  };
  read_isolated(partial_path_, open);
  open();
  if (!is_begun) file_ = h5::Handle();
  return is_begun;
}

void EnsembleWriter::write(const EnsembleRows& rows) {
  assert(rows.first_row == rows_done_);
  errno = 0;
  for (std::size_t column = 0; column < columns_.size(); ++column) {
    buffer_.resize(columns_[column].row_bytes() * rows.results.size());
    columns_[column].fill(rows, buffer_.data());
    if (h5::write_rows(datasets_[column], memory_type(columns_[column].type),
                       static_cast<hsize_t>(rows_done_), rows.results.size(), buffer_.data()) < 0)
      fail();
  }
  note_done(static_cast<std::int64_t>(rows.results.size()));
}

void EnsembleWriter::write(const std::vector<std::vector<std::byte>>& columns, std::int64_t count) {
  errno = 0;
  for (std::size_t column = 0; column < columns_.size(); ++column)
    if (h5::write_rows(datasets_[column], memory_type(columns_[column].type),
                       static_cast<hsize_t>(rows_done_), static_cast<hsize_t>(count),
                       columns[column].data()) < 0)
      fail();
  note_done(count);
}

// The rows are in the file before it says so.
void EnsembleWriter::note_done(std::int64_t rows) {
  rows_done_ += rows;
  if (H5Fflush(file_, H5F_SCOPE_GLOBAL) < 0 || H5Awrite(done_, H5T_NATIVE_INT64, &rows_done_) < 0 ||
      H5Fflush(file_, H5F_SCOPE_GLOBAL) < 0)
    fail();
}

void EnsembleWriter::commit() {
  errno = 0;
  datasets_.clear();
  if (done_.close() < 0 || H5Adelete(file_, kRowsDone) < 0 || file_.close() < 0) fail();
  take_mode(lock_, path_, 0);
  if (std::rename(partial_path_.c_str(), path_.c_str()) != 0) fail();
}

void EnsembleWriter::fail() const { fail_to_write(path_, errno == 0 ? EIO : errno); }

EnsembleReader::EnsembleReader(const std::string& path) : path_(path) {
  if (std::FILE* const file = std::fopen(path.c_str(), "rb"); file == nullptr)
    throw Failure(ExitCode::cannot_access, path + ": cannot be read: " + std::strerror(errno));
  else
    std::fclose(file);
  const auto open = [&] {
    file_ = h5::open_file(path);
    const auto head = file_.is_open() ? read_head(file_) : std::nullopt;
    if (!head) refuse(path, "is no result file of a sweep (" + std::string(kEnsembleFormat) + ")");
    head_ = *head;
    if (const auto done = h5::read_integer_attribute(file_, kRowsDone))
      refuse(path,
             fmt::format("is not complete: {} of {} members are done; continue it with --resume, or merge "
                         "the parts again",
                         *done, rows()));
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
  if (h5::read_rows(datasets_[column], memory_type(columns_[column].type), static_cast<hsize_t>(first_row),
                    static_cast<hsize_t>(count), to) < 0)
    throw Failure(ExitCode::cannot_access, path_ + ": cannot be read: the HDF5 library fails");
}

}  // namespace hyrax
