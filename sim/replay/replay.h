// A scenario through the exact step of a core, frame by frame, into any number of sinks.
#pragma once

#include <array>
#include <cassert>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "sim/core/core.h"
#include "sim/scenario/frame_clock.h"
#include "sim/scenario/scenario.h"
#include "sim/trajectory/resting_contact.h"
#include "sim/trajectory/reused.h"
#include "sim/trajectory/row_sink.h"
#include "sim/trajectory/run_summary.h"

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

struct ReplayOptions {
  /// Stop computing where the state repeats exactly at a fixed dt; the results are the same.
  bool skips_repetition = true;
  bool checks_bounds = false;  ///< Fills RunSummary::out_of_bounds_step.
};

/// Rows that repeat: whole periods, as many as fit a block.
struct Cycle {
  std::int64_t period = 0;
  std::int64_t first_step = 0;  ///< Of the first row.
  RowBlock rows;
  Reused<StretchLog> log;  ///< Of one period.
  CoreBody before;         ///< Its first row.

  /// How many rows of a period come before row `step`. REQUIRES: step >= first_step.
  [[nodiscard]] std::int64_t phase(std::int64_t step) const {
    assert(step >= first_step);
    return (step - first_step) % period;
  }
  [[nodiscard]] Row row(std::int64_t step) const { return rows.row(static_cast<std::size_t>(phase(step))); }
};

/// Plays a scenario in constant memory. Rows, contacts, blocks and the whole summary are the same bits
/// however the run is cut into calls of play_to; only how many equal blocks a sink gets at once may
/// differ. Skipping repetition changes nothing but steps_computed.
class Replay {
 public:
  /// From the start. Refers to scenario and sinks.
  /// REQUIRES: a scenario within the limits of scenario.h whose events have frames.
  Replay(const Core& core, const Scenario& scenario, std::vector<RowSink*> sinks = {},
         ReplayOptions options = {});
  Replay(const Core& core, const Scenario& scenario, RowSink& sink, ReplayOptions options = {})
      : Replay(core, scenario, std::vector<RowSink*>{&sink}, options) {}
  /// Resumes after the keyframe's row, which the sink does not get again. Contacts that touch
  /// there go on uncounted; state_hash, at_rest_since_s and the search for repetition begin at the
  /// keyframe's row.
  Replay(const Core& core, const Scenario& scenario, const Keyframe& from, RowSink& sink,
         ReplayOptions options = {});

  [[nodiscard]] std::int64_t steps() const { return steps_; }
  [[nodiscard]] const Keyframe& keyframe() const { return now_; }

  /// Plays up to row `step`, or until the state became non-finite. REQUIRES: step <= steps().
  void play_to(std::int64_t step);
  /// Ends the run at its present row: passes on what is left, and sums up.
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

  // From a keyframe's row on. @param first_step the first row that the sinks get.
  Replay(const Core& core, const Scenario& scenario, std::vector<RowSink*> sinks, ReplayOptions options,
         const Keyframe& from, std::int64_t first_step);

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
  void follow_floor(std::size_t first_row, std::int64_t first_step);
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
  void repeat_floor(const Cycle& cycle, std::int64_t end);
  void repeat_blocks(const Cycle& cycle, std::int64_t end);

  const Scenario& scenario_;
  ReplayOptions options_;
  std::shared_ptr<const Stepper> stepper_;
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
  Reused<StretchLog> log_;

  StateHash hash_;
  Tee tee_;
  RestAnchor rest_;
  RestingContact resting_;
  RunSummary summary_;
};

/// Plays all of a scenario; without sinks for its summary alone.
RunSummary replay(const Core& core, const Scenario& scenario, RowSink& sink, ReplayOptions options = {});
RunSummary replay(const Core& core, const Scenario& scenario, std::vector<RowSink*> sinks = {},
                  ReplayOptions options = {});

}  // namespace hyrax
