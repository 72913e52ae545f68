// One replay into several sinks, so that no run is played twice.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "sim/trajectory/row_sink.h"

namespace hyrax {

/// Passes each sink the rows and blocks that it wants.
class Tee {
 public:
  static constexpr std::int64_t kNoRow = std::numeric_limits<std::int64_t>::max();

  /// @param first_step the first row that the sinks may get. Refers to the sinks.
  Tee(std::span<RowSink* const> sinks, std::int64_t first_step);

  /// The next row that any of them wants; kNoRow: none.
  [[nodiscard]] std::int64_t next_row() const { return next_row_; }
  /// REQUIRES: row.step == next_row().
  void row(const Row& row);
  [[nodiscard]] bool wants_blocks() const { return wants_blocks_; }
  void block(const Block& block, std::int64_t count);
  void repeats(const Repetition& repetition);
  /// Passes on what is left. @param last the run's last row.
  void finish(const Row& last);

 private:
  struct Outlet {
    RowSink& sink;
    RowSink::Wants wants;
    std::int64_t next_row = kNoRow;
    std::int64_t last_row = -1;  // That it got.
    Columns batch = {};
  };

  void pass(Outlet& outlet, const Row& row);
  static void flush(Outlet& outlet);
  static void set_next_row(Outlet& outlet, std::int64_t after_step);
  void find_next_row();

  std::vector<Outlet> outlets_;
  std::int64_t next_row_ = kNoRow;
  bool wants_blocks_ = false;
};

}  // namespace hyrax
