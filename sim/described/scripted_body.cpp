#include "sim/described/scripted_body.h"

#include <algorithm>
#include <utility>

#include "sim/scenario/schedule.h"

namespace hyrax {

std::vector<std::int64_t> event_frames(const DescribedScenario& scenario, std::int64_t steps) {
  std::vector<EventTime> times;
  for (const DescribedEvent& event : scenario.events) {
    const auto* hitch = std::get_if<Hitch>(&event.action);
    times.push_back({event.when, hitch != nullptr ? std::optional(hitch->dt_s) : std::nullopt});
  }
  std::vector<std::int64_t> frames = schedule_events(scenario.clock, times, steps).frames;
  std::ranges::replace(frames, -1, steps);
  return frames;
}

FrameScript::FrameScript(const DescribedCore& played_core, const DescribedScenario& played)
    : core(played_core),
      scenario(played),
      clock(played.clock),
      steps(step_count(played)),
      event_frames(hyrax::event_frames(played, steps)) {}

ScriptedBody::ScriptedBody(const FrameScript& script) : script_(script), body_(script.core.make()) {
  set(SettableList::parameters, script.scenario.parameters);
  set_inputs(script.scenario.inputs, 0);
  set(SettableList::state, script.scenario.start);
}

ScriptedBody::ScriptedBody(const ScriptedBody& other, std::unique_ptr<DescribedBody> body)
    : script_(other.script_),
      body_(std::move(body)),
      row_(other.row_),
      next_event_(other.next_event_),
      is_held_(other.is_held_) {}

void ScriptedBody::play_frame() {
  begin_frame();
  if (!is_held_) body_->step(dt_s_);
  ++row_;
}

void ScriptedBody::play_frames(std::int64_t rows_max, MadeRows& rows) {
  begin_frame();
  rows.count = 0;
  rows.dt_s.assign(1, dt_s_);
  std::int64_t end = row_ + 1;
  if (is_held_) {
    body_->add_row(false, rows);
  } else {
    if (script_.scenario.input_arrays.empty()) {
      end = std::min(script_.steps, row_ + rows_max);
      if (next_event_ < script_.event_frames.size()) end = std::min(end, script_.event_frames[next_event_]);
    }
    rows.dt_s.resize(static_cast<std::size_t>(end - row_), script_.clock.dt_s(row_));
    if (!script_.clock.is_fixed())
      for (std::int64_t frame = row_ + 1; frame < end; ++frame)
        rows.dt_s[static_cast<std::size_t>(frame - row_)] = script_.clock.dt_s(frame);
    body_->play({}, rows);
  }
  row_ = end;
}

void ScriptedBody::begin_frame() {
  dt_s_ = script_.clock.dt_s(row_);
  was_changed_ = false;
  not_held_.reset();
  if (!script_.scenario.input_arrays.empty()) set_inputs({}, row_);
  for (; next_event_ < script_.event_frames.size() && script_.event_frames[next_event_] == row_;
       ++next_event_)
    apply(script_.scenario.events[next_event_].action);
}

void ScriptedBody::apply(const DescribedAction& action) {
  if (const auto* hitch = std::get_if<Hitch>(&action)) {
    dt_s_ = hitch->dt_s;
  } else if (const auto* values = std::get_if<SetValues>(&action)) {
    set(SettableList::inputs, values->inputs);
    set(SettableList::state, values->state);
    was_changed_ = true;
  } else if (const auto* act = std::get_if<Act>(&action)) {
    body_->act(act->action, act->arguments);
    was_changed_ = true;
  } else {
    is_held_ = std::holds_alternative<Hold>(action);
  }
}

void ScriptedBody::contacts(std::span<std::uint8_t> flags) const {
  if (is_held_ || row_ == 0)
    std::fill(flags.begin(), flags.end(), std::uint8_t{0});
  else if (!flags.empty())
    body_->contacts(flags);
}

void ScriptedBody::set(SettableList list, const std::vector<GivenValue>& given) {
  if (given.empty()) return;
  std::vector<std::optional<Word>> words(list_of(script_.core.description, list).values.size());
  for (const auto& [place, word] : given) words[place] = word;
  body_->set(list, words);
  if (not_held_) return;
  std::vector<Word> read(words.size());
  body_->read(list, read);
  for (std::size_t place = 0; place < words.size() && !not_held_; ++place)
    if (words[place] && *words[place] != read[place]) not_held_ = ValueNotHeld{list, place};
}

void ScriptedBody::set_inputs(const std::vector<GivenValue>& given, std::int64_t frame) {
  std::vector<GivenValue> values = given;
  for (const InputArray& array : script_.scenario.input_arrays)
    if (!array.words.empty()) values.emplace_back(array.input, array.words[static_cast<std::size_t>(frame)]);
  set(SettableList::inputs, values);
}

}  // namespace hyrax
