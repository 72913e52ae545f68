#include "tools/store/trajectory_csv.h"

#include <cerrno>

#include "tools/files/json.h"

namespace hyrax {

TrajectoryCsv::TrajectoryCsv(const std::string& path, std::int64_t rows_every)
    : path_(path),
      rows_every_(rows_every),
      target_(path),
      file_(std::fopen(target_.part_path().c_str(), "wb")) {
  if (!file_) fail_to_write(path_, errno);
  write("step,t_s,dt_s,x_px,y_px,vx_px_per_s,vy_px_per_s,contact\n");
}

void TrajectoryCsv::rows(const Columns& batch) {
  std::string text;
  for (std::size_t index = 0; index < batch.size(); ++index) {
    const Row row = batch.row(index);
    text += std::to_string(row.step);
    for (const double value : {row.t_s, row.dt_s, row.x_px, row.y_px, row.vx_px_per_s, row.vy_px_per_s})
      text.append(",").append(to_text(value));
    text.append(",").append(std::to_string(row.contact)).append("\n");
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
