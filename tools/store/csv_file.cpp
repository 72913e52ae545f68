#include "tools/store/csv_file.h"

#include <cerrno>
#include <filesystem>
#include <system_error>

#include "tools/files/failure.h"
#include "tools/files/printable.h"
#include "tools/platform/path.h"
#include "tools/platform/standard_streams.h"

namespace hyrax {

CsvFile::CsvFile(const std::string& path, std::int64_t rows, std::size_t columns) : path_(path) {
  if (path == kStandardOutput) {
    file_.reset(open_standard_output());
  } else {
    file_.reset(open_file(target_.emplace(path).part_path(), "wb"));
    require_disk_space(path, rows, 2 * columns);  // A digit and a comma for each number.
  }
  if (!file_) fail();
}

void CsvFile::append(std::string_view text) {
  constexpr std::size_t kBatchBytes = 1 << 18;
  text_ += text;
  if (text_.size() >= kBatchBytes) write();
}

void CsvFile::finish() {
  write();
  if (std::fclose(file_.release()) != 0) fail();
  if (target_) target_->commit();
}

void CsvFile::write() {
  if (std::fwrite(text_.data(), 1, text_.size(), file_.get()) != text_.size()) fail();
  text_.clear();
}

void CsvFile::fail() const {
  if (path_ == kStandardOutput)
    throw Failure(ExitCode::cannot_access, "hyrax-sim: standard output cannot be written");
  fail_to_write(path_, errno);
}

std::uint64_t require_disk_space(const std::string& path, std::int64_t rows, std::uint64_t row_bytes) {
  const std::uint64_t bytes = row_bytes * static_cast<std::uint64_t>(rows);
  std::error_code error;
  const std::filesystem::path folder = std::filesystem::absolute(path).parent_path();
  const std::filesystem::space_info space = std::filesystem::space(folder, error);
  if (!error && bytes > space.available)
    throw Failure(ExitCode::cannot_access, path + ": cannot be written: its rows need at least " +
                                               size_text(bytes) + " (found " + size_text(space.available) +
                                               " free); record fewer with /record/every");
  return bytes;
}

}  // namespace hyrax
