#include "tools/store/trajectory_csv.h"

#include <cerrno>

#include "tools/files/json.h"
#include "tools/store/trajectory_format.h"

namespace hyrax {
namespace {

// A column's name and unit, as "vx_px_per_s".
std::string header_of(const RowColumn& column) {
  std::string text = std::string(column.name) + "_";
  for (const char letter : std::string_view(column.unit))
    text += letter == '/' ? "_per_" : std::string(1, letter);
  return text;
}

}  // namespace

TrajectoryCsv::TrajectoryCsv(const std::string& path, std::int64_t rows_every)
    : path_(path),
      rows_every_(rows_every),
      target_(path),
      file_(std::fopen(target_.part_path().c_str(), "wb")) {
  if (!file_) fail_to_write(path_, errno);
  std::string header = "step";
  for (const RowColumn& column : kRowColumns) header.append(",").append(header_of(column));
  write(header + ",contact\n");
}

void TrajectoryCsv::rows(const Columns& batch) {
  std::string text;
  for (std::size_t index = 0; index < batch.size(); ++index) {
    text += std::to_string(batch.step[index]);
    for (const RowColumn& column : kRowColumns)
      text.append(",").append(to_text((batch.*column.values)[index]));
    text.append(",").append(std::to_string(batch.contact[index])).append("\n");
  }
  write(text);
}

void TrajectoryCsv::finish() {
  if (std::fclose(file_.release()) != 0) fail_to_write(path_, errno);
  target_.commit();
}

void TrajectoryCsv::write(const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size()) fail_to_write(path_, errno);
}

}  // namespace hyrax
