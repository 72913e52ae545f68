#include "sim/replay/player.h"

#include <algorithm>

#include "sim/scenario/schedule.h"

namespace hyrax {
namespace {

Keyframe start_of(const Scenario& scenario) {
  Keyframe start;
  start.row.x_px = scenario.start.x_px;
  start.row.y_px = scenario.start.y_px;
  start.row.vx_px_per_s = scenario.start_velocity.vx_px_per_s;
  start.row.vy_px_per_s = scenario.start_velocity.vy_px_per_s;
  start.window = scenario.window;
  start.sprite = scenario.sprite;
  return start;
}

bool is_finite(const Body& body) {
  return is_finite_state({.x_px = body.x_px,
                          .y_px = body.y_px,
                          .vx_px_per_s = body.vx_px_per_s,
                          .vy_px_per_s = body.vy_px_per_s});
}

}  // namespace

Replay::Player::Player(const Scenario& scenario, const Keyframe& from, std::uint8_t contact_before,
                       RowSink& sink, ReplayOptions options)
    : scenario_(scenario),
      sink_(sink),
      wants_(sink.wants()),
      options_(options),
      clock_(scenario.clock),
      steps_(step_count(scenario)),
      event_frames_(schedule_events(scenario, steps_).frames),
      now_(from),
      contacts_(sink, contact_before, from.row.step),
      rest_(from.row.x_px, from.row.y_px, from.row.t_s) {
  const auto next = std::lower_bound(event_frames_.begin(), event_frames_.end(), from.row.step);
  next_event_ = static_cast<std::size_t>(next - event_frames_.begin());
  const Row& row = from.row;
  pack_row(block_.extend(1), row.dt_s, row.x_px, row.y_px, row.vx_px_per_s, row.vy_px_per_s, row.contact);
  block_keyframe_ = from;
  see_bounds(row);
}

Replay::Player::Player(const Scenario& scenario, RowSink& sink, ReplayOptions options)
    : Player(scenario, start_of(scenario), 0, sink, options) {
  if (wants_.rows_every > 0) record(now_.row);
}

Replay::Player::Player(const Scenario& scenario, const Keyframe& from, RowSink& sink, ReplayOptions options)
    : Player(scenario, from, from.row.contact, sink, options) {
  const std::int64_t every = wants_.rows_every;
  if (every > 0) next_recorded_step_ = (from.row.step / every + 1) * every;
}

void Replay::Player::play_to(std::int64_t step_end) {
  while (step() < step_end && !summary_.non_finite_step) {
    apply_events();
    const std::int64_t next_event_frame =
        next_event_ < event_frames_.size() ? event_frames_[next_event_] : steps_;
    const std::int64_t end = std::min(step_end, next_event_frame);
    if (hitch_dt_s_)
      play_hitch();
    else if (clock_.is_fixed())
      play_even_stretch(end);
    else
      play_uneven_stretch(end);
  }
}

Body Replay::Player::body() const {
  return {now_.row.x_px, now_.row.y_px, now_.row.vx_px_per_s, now_.row.vy_px_per_s};
}

Stretch Replay::Player::stretch(std::int64_t frames) {
  return {.window = now_.window,
          .sprite = now_.sprite,
          .is_held = now_.is_held,
          .contact_before = now_.row.contact,
          .dt_s = dt_s_.data(),
          .frames = frames};
}

// Takes the row's dt at once, with the events of the frame to come.
void Replay::Player::apply_events() {
  for (; next_event_ < event_frames_.size() && event_frames_[next_event_] == step(); ++next_event_)
    apply(scenario_.events[next_event_].action);
}

void Replay::Player::apply(const Action& action) {
  Row& row = now_.row;
  const auto set_velocity = [&row](const Velocity& velocity) {
    row.vx_px_per_s = velocity.vx_px_per_s;
    row.vy_px_per_s = velocity.vy_px_per_s;
  };
  if (const auto* fling = std::get_if<Fling>(&action)) set_velocity(fling->velocity);
  if (std::holds_alternative<Stop>(action)) set_velocity({});
  if (const auto* hitch = std::get_if<Hitch>(&action)) hitch_dt_s_ = hitch->dt_s;
  if (const auto* place = std::get_if<Place>(&action)) {
    row.x_px = place->position.x_px;
    row.y_px = place->position.y_px;
  }
  if (const auto* resize = std::get_if<Resize>(&action)) {
    now_.window = resize->window.value_or(now_.window);
    now_.sprite = resize->sprite.value_or(now_.sprite);
  }
  if (std::holds_alternative<Grab>(action)) {
    set_velocity({});
    now_.is_held = true;
  }
  if (const auto* release = std::get_if<Release>(&action)) {
    set_velocity(release->velocity);
    now_.is_held = false;
  }
}

void Replay::Player::play_hitch() {
  dt_s_.assign(1, *hitch_dt_s_);
  hitch_dt_s_.reset();
  play_batch(stretch(1));
}

void Replay::Player::play_even_stretch(std::int64_t end) {
  dt_s_.assign(1, clock_.dt_s(step()));
  Search search{body(), step()};
  while (step() < end && !summary_.non_finite_step) {
    const std::int64_t search_end = search.step + search.window;
    Stretch next = stretch(std::min<std::int64_t>({end, search_end}) - step());
    next.frames = std::min(next.frames, static_cast<std::int64_t>(block_.room()));
    next.anchor = &search.anchor;
    play_batch(next);
    const std::int64_t period = step() - search.step;
    if (log_.met_anchor && end - step() > 2 * period) return repeat(period, end);
    if (step() == search_end || log_.met_anchor)
      search = {body(), step(), std::min<std::int64_t>(search.window + search.window / 16, kBlockRows)};
  }
}

void Replay::Player::play_uneven_stretch(std::int64_t end) {
  while (step() < end && !summary_.non_finite_step) {
    const std::int64_t frames = std::min(end - step(), static_cast<std::int64_t>(block_.room()));
    dt_s_.resize(static_cast<std::size_t>(frames));
    for (std::int64_t frame = 0; frame < frames; ++frame)
      dt_s_[static_cast<std::size_t>(frame)] = clock_.dt_s(step() + frame);
    Stretch next = stretch(frames);
    next.is_dt_fixed = false;
    play_batch(next);
  }
}

void Replay::Player::play_batch(const Stretch& stretch) {
  const std::size_t rows_before = block_.size();
  Body moved = body();
  play(stretch, moved, block_, log_);
  if (!is_finite(moved)) cut_to_first_non_finite(stretch, body(), rows_before);
  if (!stretch.is_held) {
    summary_.had_drag = true;
    summary_.had_gravity |= std::any_of(dt_s_.begin(), dt_s_.end(), [](double dt_s) { return dt_s > 0.0; });
  }
  summary_.steps_computed += log_.frames;
  take_in(rows_before);
  if (block_.room() == 0) close_block();
}

// In a stretch nothing makes a non-finite state finite again, so its end tells of it; then the
// stretch is played once more, just as far as it arose.
void Replay::Player::cut_to_first_non_finite(Stretch stretch, Body start, std::size_t rows_before) {
  std::size_t row = rows_before;
  while (is_finite_state(block_.row(row))) ++row;
  block_.shrink(rows_before);
  stretch.frames = static_cast<std::int64_t>(row - rows_before) + 1;
  play(stretch, start, block_, log_);
  summary_.non_finite_step = step() + stretch.frames;
}

void Replay::Player::take_in(std::size_t first_row) {
  auto begun = log_.begun.begin();
  for (std::size_t index = first_row; index < block_.size(); ++index) {
    Row row = block_.row(index);
    now_.timeline.play(row.dt_s);
    row.step = step() + 1;
    row.t_s = now_.timeline.time_s();
    for (; begun != log_.begun.end() && begun->offset == static_cast<std::int64_t>(index - first_row);
         ++begun) {
      begun->contact.step = begun->contact.last_step = row.step;
      begun->contact.t_s = row.t_s;
      contacts_.begin(begun->contact);
    }
    see(row);
    now_.row = row;
    if (index == 0) block_keyframe_ = now_;
  }
  for (std::size_t wall = 0; wall < kWalls.size(); ++wall)
    summary_.clamped_steps[wall] += log_.clamped_steps[wall];
  summary_.rest_steps += log_.rest_steps;
  summary_.had_friction |= log_.had_friction;
}

void Replay::Player::see(const Row& row) {
  if (row.contact != 0) contacts_.touch(row.contact, row.step);
  if (rest_.is_moved(row.x_px, row.y_px)) rest_.move(row.x_px, row.y_px, row.t_s);
  see_bounds(row);
  if (wants_.rows_every > 0 && row.step == next_recorded_step_) record(row);
}

void Replay::Player::see_bounds(const Row& row) {
  if (!options_.checks_bounds || summary_.out_of_bounds_step) return;
  const bool is_inside = row.x_px >= 0.0 && row.x_px <= now_.window.width_px - now_.sprite.width_px &&
                         row.y_px >= 0.0 && row.y_px <= now_.window.height_px - now_.sprite.height_px;
  if (!is_inside) summary_.out_of_bounds_step = row.step;
}

void Replay::Player::record(const Row& row) {
  recorded_.append(row);
  next_recorded_step_ = row.step + wants_.rows_every;
  if (recorded_.size() >= kBlockRows) flush_rows();
}

void Replay::Player::flush_rows() {
  if (recorded_.size() > 0) sink_.rows(recorded_);
  recorded_.clear();
}

void Replay::Player::close_block(std::int64_t count) {
  const Digest block_digest = digest(block_);
  hash_.add(block_digest, count);
  if (wants_.blocks) sink_.block({block_digest, block_keyframe_, block_}, count);
  block_.shrink(0);
}

RunSummary Replay::Player::finish() {
  if (block_.size() > 0) close_block();
  const std::int64_t last_recorded_step = next_recorded_step_ - wants_.rows_every;
  if (wants_.rows_every > 0 && last_recorded_step != step()) record(now_.row);
  flush_rows();
  contacts_.finish();
  summary_.steps = step();
  summary_.simulated_s = now_.row.t_s;
  summary_.contacts = contacts_.counts();
  summary_.final = now_.row;
  summary_.at_rest_since_s = rest_.at_rest_since_s(now_.row.t_s);
  summary_.state_hash = hash_.value();
  return summary_;
}

}  // namespace hyrax
