// What a run passes on to its sinks.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "sim/trajectory/row_sink.h"

namespace hyrax {

/// Passes each sink the rows, blocks and contacts that it wants, and counts the contacts.
class Tee {
 public:
  /// @param first_step the first row that the sinks may get. Refers to the sinks.
  Tee(std::span<RowSink* const> sinks, std::int64_t first_step);

  /// The next row that any of them wants; the largest number: none.
  [[nodiscard]] std::int64_t next_row() const { return next_row_; }
  /// REQUIRES: row.step == next_row().
  void row(const Row& row);
  [[nodiscard]] bool wants_blocks() const { return wants_blocks_; }
  void block(const Block& block, std::int64_t count);
  void repeats(const Repetition& repetition);

  /// `contact` begins at its step, or ended in the step before.
  void contact(const Contact& contact, bool begins);
  /// Counts contacts that need not be passed on. REQUIRES: is_full(), or there are none.
  void count_contacts(const WallCounts& begun);
  [[nodiscard]] const WallCounts& contacts() const { return contacts_; }
  /// Whether no further contact will be passed on.
  [[nodiscard]] bool is_full() const { return contacts_passed_ >= contacts_max_; }

  /// Passes on what is left. @param last the run's last row, at which contacts that go on end.
  void finish(const Row& last);

 private:
  static constexpr std::int64_t kNone = -1;
  struct Outlet {
    RowSink& sink;
    RowSink::Wants wants;
    std::int64_t next_row = 0;
    std::int64_t last_row = kNone;  // That it got.
    Reused<Columns> batch = {};     // Rows that it does not have yet.
  };
  struct OpenContact {
    std::int64_t index = kNone;  // Among those passed on.
    std::int64_t step = 0;
  };

  static void pass(Outlet& outlet, const Row& row);
  static void flush(Outlet& outlet);
  static void set_next_row(Outlet& outlet, std::int64_t after_step);
  void find_next_row();
  void end_contact(Wall wall, std::int64_t last_step);

  std::vector<Outlet> outlets_;
  std::int64_t next_row_ = 0;
  bool wants_blocks_ = false;
  std::int64_t contacts_max_ = 0;
  std::int64_t contacts_passed_ = 0;
  std::array<OpenContact, 4> open_;
  WallCounts contacts_{};
};

}  // namespace hyrax
