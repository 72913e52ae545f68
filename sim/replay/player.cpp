#include "sim/replay/replay.h"

#include <algorithm>
#include <utility>

#include "sim/scenario/schedule.h"

namespace hyrax {
namespace {

Keyframe start_of(const Scenario& scenario) {
  Keyframe start;
  set_state(start.row, start_state(scenario));
  start.window = scenario.window;
  start.sprite = scenario.sprite;
  return start;
}

}  // namespace

Replay::Replay(const Core& core, const Scenario& scenario, std::vector<RowSink*> sinks, ReplayOptions options)
    : Replay(core, scenario, std::move(sinks), options, start_of(scenario), 0) {}
Replay::Replay(const Core& core, const Scenario& scenario, const Keyframe& from, RowSink& sink,
               ReplayOptions options)
    : Replay(core, scenario, {&sink}, options, from, from.row.step + 1) {}

Replay::Replay(const Core& core, const Scenario& scenario, std::vector<RowSink*> sinks, ReplayOptions options,
               const Keyframe& from, std::int64_t first_step)
    : scenario_(scenario),
      options_(options),
      stepper_(core.stepper),
      clock_(scenario.clock),
      steps_(step_count(scenario)),
      event_frames_(schedule_events(scenario, steps_).frames),
      now_(from),
      tee_(sinks, first_step),
      rest_{from.row.x_px, from.row.y_px, from.row.t_s} {
  const auto next = std::lower_bound(event_frames_.begin(), event_frames_.end(), from.row.step);
  next_event_ = static_cast<std::size_t>(next - event_frames_.begin());
  block_.append(from.row);
  block_keyframe_ = from;
  check_bounds(from.row);
  if (tee_.next_row() == from.row.step) tee_.row(from.row);
}

void Replay::play_to(std::int64_t step_end) {
  assert(step_end <= steps_);
  while (step() < step_end && !summary_.non_finite_step) {
    apply_events();
    const std::int64_t stretch_end = next_event_ < event_frames_.size() ? event_frames_[next_event_] : steps_;
    const std::int64_t end = std::min(step_end, stretch_end);
    if (hitch_dt_s_)
      play_hitch();
    else if (clock_.is_fixed())
      play_even_stretch(end, stretch_end);
    else
      play_uneven_stretch(end);
  }
}

CoreBody Replay::body() const { return {state_of(now_.row), now_.core_object}; }

Stretch Replay::stretch(std::int64_t frames) const {
  return {.window = now_.window,
          .sprite = now_.sprite,
          .is_held = now_.is_held,
          .contact_before = now_.row.contact,
          .dt_s = dt_s_.data(),
          .is_dt_fixed = dt_s_.size() == 1,
          .frames = frames,
          .from_step = step()};
}

// Takes the row's dt at once, with the events of the frame to come.
void Replay::apply_events() {
  for (; next_event_ < event_frames_.size() && event_frames_[next_event_] == step(); ++next_event_) {
    const Action& action = scenario_.events[next_event_].action;
    stepper_->apply(action, now_);
    search_.reset();
    cycle_.reset();
    if (const auto* hitch = std::get_if<Hitch>(&action)) hitch_dt_s_ = hitch->dt_s;
  }
}

// Frames that the block has room for. Its first row is played alone, so that its keyframe is of that row.
std::int64_t Replay::room() const {
  return block_.size() == 0 && tee_.wants_blocks() ? 1 : static_cast<std::int64_t>(block_.room());
}

void Replay::play_hitch() {
  dt_s_.assign(1, *hitch_dt_s_);
  hitch_dt_s_.reset();
  play_batch(stretch(1));
}

void Replay::play_even_stretch(std::int64_t end, std::int64_t stretch_end) {
  dt_s_.assign(1, clock_.dt_s(step()));
  while (step() < end && !summary_.non_finite_step) {
    if (!cycle_)
      search_repetition(end, stretch_end);
    else if (options_.skips_repetition)
      repeat(*cycle_, end);
    else
      play_batch(stretch(std::min(end - step(), room())));
  }
}

// What is found depends on where the stretch ends, never on `end`, where the caller stops for now.
void Replay::search_repetition(std::int64_t end, std::int64_t stretch_end) {
  if (!search_) search_ = {body(), step()};
  const std::int64_t search_end = search_->step + search_->window;
  Stretch next = stretch(std::min({end - step(), search_end - step(), room()}));
  next.anchor = &search_->anchor;
  play_batch(next);
  if (summary_.non_finite_step) return;
  const std::int64_t period = step() - search_->step;
  if (log_->met_anchor && stretch_end - step() > 2 * period) {
    cycle_ = make_cycle(period);
    if (stretch_end < steps_) return;
    // An event changes the state of its frame's row, which then does not repeat.
    const bool begins_with_event = next_event_ > 0 && event_frames_[next_event_ - 1] == search_->step;
    const std::int64_t from_step = search_->step + (begins_with_event ? 1 : 0);
    summary_.periodic_from_step = from_step;
    summary_.period_steps = period;
    tee_.repeats({from_step, period});
  } else if (log_->met_anchor || step() == search_end) {
    const auto window = std::min<std::int64_t>(search_->window + search_->window / 16, kBlockRows);
    search_ = {body(), step(), window};
  }
}

void Replay::play_uneven_stretch(std::int64_t end) {
  while (step() < end && !summary_.non_finite_step) {
    const std::int64_t frames = std::min(end - step(), room());
    dt_s_.resize(static_cast<std::size_t>(frames));
    for (std::int64_t frame = 0; frame < frames; ++frame)
      dt_s_[static_cast<std::size_t>(frame)] = clock_.dt_s(step() + frame);
    play_batch(stretch(frames));
  }
}

void Replay::play_batch(const Stretch& stretch) {
  const std::size_t rows_before = block_.size();
  const RestAnchor rest_before = rest_;
  CoreBody moved = body();
  stepper_->play(stretch, moved, rest_, block_, *log_);
  if (!is_finite(moved.state)) {
    rest_ = rest_before;
    cut_to_first_non_finite(stretch, rows_before);
  }
  if (!stretch.is_held) {
    summary_.had_drag = true;
    summary_.had_gravity |= std::any_of(dt_s_.begin(), dt_s_.end(), [](double dt_s) { return dt_s > 0.0; });
  }
  summary_.steps_computed += log_->frames;
  now_.core_object = std::move(moved.object);
  pass_on(rows_before);
  if (block_.room() == 0) close_block();
}

// In a stretch nothing makes a non-finite state finite again, so the state at its end shows it; then the
// stretch is played once more, up to the row in which it arose.
void Replay::cut_to_first_non_finite(Stretch stretch, std::size_t rows_before) {
  std::size_t row = rows_before;
  while (is_finite(state_of(block_.row(row)))) ++row;
  block_.shrink(rows_before);
  stretch.frames = static_cast<std::int64_t>(row - rows_before) + 1;
  CoreBody moved = body();
  stepper_->play(stretch, moved, rest_, block_, *log_);
  summary_.non_finite_step = step() + stretch.frames;
}

void Replay::pass_on(std::size_t first_row) {
  const std::int64_t first_step = step() + 1;
  play_time();
  count_clamps(*log_, 1);
  follow_floor(first_row, first_step);
  pass_on_changes(*log_, first_step);
  if (log_->moved_offset >= 0) rest_.t_s = time_in_batch_s(log_->moved_offset);
  const auto row_at = [&](std::int64_t offset) {
    Row row = block_.row(first_row + static_cast<std::size_t>(offset));
    row.step = first_step + offset;
    row.t_s = time_in_batch_s(offset);
    return row;
  };
  if (options_.checks_bounds)
    for (std::int64_t offset = 0; offset < log_->frames; ++offset) check_bounds(row_at(offset));
  while (tee_.next_row() < first_step + log_->frames) tee_.row(row_at(tee_.next_row() - first_step));
  now_.row = row_at(log_->frames - 1);
  if (first_row == 0) block_keyframe_ = now_;
}

// Frames of one dt lie in one segment of time, where any row's time is a product away; else each
// frame may begin a segment, and the times are kept.
void Replay::play_time() {
  if (dt_s_.size() == 1) return now_.timeline.play(dt_s_.front(), log_->frames);
  batch_times_s_.resize(static_cast<std::size_t>(log_->frames));
  for (std::size_t offset = 0; offset < batch_times_s_.size(); ++offset) {
    now_.timeline.play(dt_s_[offset]);
    batch_times_s_[offset] = now_.timeline.time_s();
  }
}

double Replay::time_in_batch_s(std::int64_t offset) const {
  if (dt_s_.size() == 1) return now_.timeline.time_s(offset + 1 - log_->frames);
  return batch_times_s_[static_cast<std::size_t>(offset)];
}

// Rows are looked at from a ground contact on until one is off the floor. Where the anchor of rest stays on
// it, so do they.
void Replay::follow_floor(std::size_t first_row, std::int64_t first_step) {
  const double floor_px = bounds_of(now_.window, now_.sprite).bottom_px;
  const bool is_still = log_->moved_offset < 0 && rest_.y_px == floor_px;
  std::int64_t offset = 0;
  const auto look_up_to = [&](std::int64_t end) {
    for (; resting_.open_from_step() && !is_still && offset < end; ++offset)
      if (!RestingContact::is_near(block_.row(first_row + static_cast<std::size_t>(offset)).y_px, floor_px))
        resting_.leave();
    offset = end;
  };
  if (next_event_ > 0 && event_frames_[next_event_ - 1] == first_step - 1) resting_.end(first_step - 1);
  resting_.enter(first_step, now_.row.contact, block_.row(first_row).contact);
  for (const ContactChange& change : log_->changes) {
    if (change.contact.wall != Wall::ground || !change.begins) continue;
    look_up_to(change.offset);
    resting_.begin(first_step + change.offset);
  }
  look_up_to(log_->frames);
}

void Replay::pass_on_changes(const StretchLog& log, std::int64_t first_step) {
  for (const ContactChange& change : log.changes) {
    Contact contact = change.contact;
    contact.step = contact.last_step = first_step + change.offset;
    contact.t_s = time_in_batch_s(change.offset);
    tee_.contact(contact, change.begins);
  }
}

void Replay::count_clamps(const StretchLog& log, std::int64_t times) {
  for (const Wall wall : kWalls)
    summary_.clamped_steps[wall] += times * log.rows_with(static_cast<std::uint8_t>(wall));
  summary_.rest_steps += times * log.rows_with(kRestBit);
  summary_.had_friction |= log.had_friction;
}

void Replay::check_bounds(const Row& row) {
  if (!options_.checks_bounds || summary_.out_of_bounds_step) return;
  const Bounds bounds = bounds_of(now_.window, now_.sprite);
  const bool is_inside =
      row.x_px >= 0.0 && row.x_px <= bounds.right_px && row.y_px >= 0.0 && row.y_px <= bounds.bottom_px;
  if (!is_inside) summary_.out_of_bounds_step = row.step;
}

void Replay::close_block(std::int64_t count) {
  const Digest block_digest = digest(block_);
  hash_.add(block_digest, count);
  if (tee_.wants_blocks()) tee_.block({block_digest, block_keyframe_, block_}, count);
  block_.shrink(0);
}

RunSummary Replay::finish() {
  if (block_.size() > 0) close_block();
  tee_.finish(now_.row);
  resting_.end(step());
  summary_.steps = step();
  summary_.simulated_s = now_.row.t_s;
  summary_.contacts = summary_.bounces = tee_.contacts();
  summary_.bounces.ground -= resting_.contacts();
  summary_.resting_contact_from_step = resting_.from_step();
  summary_.final = now_.row;
  summary_.at_rest_since_s = rest_.at_rest_since_s(now_.row.t_s);
  summary_.state_hash = hash_.value();
  return summary_;
}

RunSummary replay(const Core& core, const Scenario& scenario, std::vector<RowSink*> sinks,
                  ReplayOptions options) {
  Replay run(core, scenario, std::move(sinks), options);
  run.play_to(run.steps());
  return run.finish();
}
RunSummary replay(const Core& core, const Scenario& scenario, RowSink& sink, ReplayOptions options) {
  return replay(core, scenario, std::vector<RowSink*>{&sink}, options);
}

}  // namespace hyrax
