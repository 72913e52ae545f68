// The replay's inside: plays stretches, and passes on of every row what the sinks want.
#pragma once

#include <array>
#include <cassert>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "sim/core/core.h"
#include "sim/replay/replay.h"
#include "sim/scenario/frame_clock.h"
#include "sim/trajectory/row.h"
#include "sim/trajectory/row_sink.h"
#include "sim/trajectory/run_summary.h"

namespace hyrax {

class ContactTracker {
 public:
  /// Refers to the sinks.
  explicit ContactTracker(std::span<RowSink* const> sinks);

  /// A contact begins at contact.step.
  void begin(const Contact& contact);
  /// The wall clamped for the last time at `last_step`.
  void end(Wall wall, std::int64_t last_step);
  /// `contact` begins at its step, or ended in the step before.
  void change(const Contact& contact, bool begins) {
    begins ? begin(contact) : end(contact.wall, contact.step - 1);
  }
  /// Counts contacts that need not be passed on. REQUIRES: is_full(), or there are none.
  void count(const WallCounts& begun);
  /// The run ends at `last_step`, and with it the contacts that go on.
  void finish(std::int64_t last_step);

  [[nodiscard]] const WallCounts& counts() const { return counts_; }
  /// Whether no further contact will be passed on.
  [[nodiscard]] bool is_full() const { return passed_ >= passed_max_; }

 private:
  static constexpr std::int64_t kNone = -1;
  struct Open {
    std::int64_t index = kNone;  ///< Among those passed on.
    std::int64_t step = 0;
  };

  std::vector<RowSink*> sinks_;
  std::int64_t passed_max_;
  std::int64_t passed_ = 0;
  std::array<Open, 4> open_;
  WallCounts counts_{};
};

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

/// Rows that repeat: whole periods, as many as fit a block.
struct Cycle {
  std::int64_t period = 0;
  std::int64_t first_step = 0;  ///< Of the first row.
  RowBlock rows;
  StretchLog log;   ///< Of one period.
  CoreBody before;  ///< Its first row.

  /// How many rows of a period come before row `step`. REQUIRES: step >= first_step.
  [[nodiscard]] std::int64_t phase(std::int64_t step) const {
    assert(step >= first_step);
    return (step - first_step) % period;
  }
  [[nodiscard]] Row row(std::int64_t step) const { return rows.row(static_cast<std::size_t>(phase(step))); }
};

class Replay::Player {
 public:
  /// @param first_step the first row that the sinks get.
  Player(const Core& core, const Scenario& scenario, std::vector<RowSink*> sinks, ReplayOptions options,
         const Keyframe& from, std::int64_t first_step);

  [[nodiscard]] std::int64_t steps() const { return steps_; }
  [[nodiscard]] const Keyframe& now() const { return now_; }
  void play_to(std::int64_t step);
  RunSummary finish();

 private:
  // The search for a repetition: a state is compared with the anchor, which moves on by a window that
  // grows with the run, so that any period up to a block is found in the end. It lasts as long as a
  // stretch without input, however many calls of play_to that takes.
  struct Search {
    CoreBody anchor;
    std::int64_t step = 0;
    std::int64_t window = 256;
  };

  [[nodiscard]] std::int64_t step() const { return now_.row.step; }
  [[nodiscard]] CoreBody body() const;
  [[nodiscard]] Stretch stretch(std::int64_t frames) const;
  [[nodiscard]] std::int64_t room() const;
  void apply_events();
  void play_hitch();
  void play_even_stretch(std::int64_t end, std::int64_t stretch_end);
  void search_repetition(std::int64_t end, std::int64_t stretch_end);
  void play_uneven_stretch(std::int64_t end);
  void play_batch(const Stretch& stretch);
  void cut_to_first_non_finite(Stretch stretch, std::size_t rows_before);
  void pass_on(std::size_t first_row);
  void play_time();
  [[nodiscard]] double time_in_batch_s(std::int64_t offset) const;
  void pass_on_changes(const StretchLog& log, std::int64_t first_step);
  void count_clamps(const StretchLog& log, std::int64_t times);
  void check_bounds(const Row& row);
  void close_block(std::int64_t count = 1);

  // In repetition.cpp: frames of a stretch that repeats with the period found.
  void repeat(const Cycle& cycle, std::int64_t end);
  [[nodiscard]] Cycle make_cycle(std::int64_t period) const;
  [[nodiscard]] Row row_in(const Cycle& cycle, std::int64_t at) const;
  [[nodiscard]] Keyframe keyframe_in(const Cycle& cycle, std::int64_t at) const;
  void repeat_clamps(const Cycle& cycle, std::int64_t end);
  void repeat_contacts(const Cycle& cycle, std::int64_t end);
  void repeat_changes(const Cycle& cycle, std::int64_t first, std::int64_t last);
  void repeat_rest(const Cycle& cycle, std::int64_t end);
  void repeat_blocks(const Cycle& cycle, std::int64_t end);

  const Scenario& scenario_;
  ReplayOptions options_;
  std::shared_ptr<const Kernel> kernel_;
  FrameClock clock_;
  std::int64_t steps_;
  std::vector<std::int64_t> event_frames_;
  std::size_t next_event_ = 0;
  std::optional<double> hitch_dt_s_;
  std::optional<Search> search_;
  std::optional<Cycle> cycle_;

  Keyframe now_;
  RowBlock block_;
  Keyframe block_keyframe_;
  std::vector<double> dt_s_;  // Of the batch: one for all its frames, or one a frame.
  std::vector<double> batch_times_s_;
  StretchLog log_;

  StateHash hash_;
  Tee tee_;
  ContactTracker contacts_;
  RestAnchor rest_;
  RunSummary summary_;
};

}  // namespace hyrax
