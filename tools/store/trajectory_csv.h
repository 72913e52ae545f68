// Writes a run to a file of comma-separated values as it is played, for spreadsheets.
#pragma once

#include <cstdio>
#include <memory>
#include <string>

#include "sim/trajectory/row_sink.h"
#include "tools/files/atomic_file.h"

namespace hyrax {

/// The header "step,t_s,dt_s,x_px,y_px,vx_px_per_s,vy_px_per_s,contact", then every record.every-th row.
/// Numbers are shortest-round-trip; contact has the bits of a trajectory file. Memory does not grow with the
/// run. The file is at `path` only after finish(). ERRORS: every call may throw
/// Failure(cannot_access) "PATH: cannot be written: REASON".
class TrajectoryCsv : public RowSink {
 public:
  TrajectoryCsv(const std::string& path, std::int64_t rows_every);

  [[nodiscard]] Wants wants() const override { return {.rows_every = rows_every_, .contacts = false}; }
  void rows(const Columns& batch) override;
  void finish();

 private:
  void write(const std::string& text);

  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  std::string path_;
  std::int64_t rows_every_;
  AtomicFile target_;
  std::unique_ptr<std::FILE, Close> file_;
};

}  // namespace hyrax
