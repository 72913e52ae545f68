#include "tools/recorder/core_recorder.h"

#include <cassert>
#include <stdexcept>

#include "sim/described/scripted_body.h"
#include "tools/described/scenario_json.h"
#include "tools/recorder/tape.h"

namespace hyrax {
namespace {

// What a default constructed core has, too, is left out.
std::vector<GivenValue> given(const ValueList& list, const std::vector<Word>& words) {
  std::vector<GivenValue> values;
  for (std::size_t place = 0; place < words.size(); ++place)
    if (words[place] != list.values[place].initial) values.emplace_back(place, words[place]);
  return values;
}

}  // namespace

CoreTape::CoreTape(const CoreMoment& start) : start_(start) {
  KeptRow row = start.row;
  row.dt_s = 0.0;
  row.contacts.assign(row.contacts.size(), 0);
  add_frame(row);
  row_bytes_ = rows_.size();
}

void CoreTape::add_frame(const KeptRow& row) {
  pack_row({.dt_s = row.dt_s, .state = row.state, .contacts = row.contacts}, rows_);
}

DescribedScenario CoreTape::scenario(const std::string& name) const {
  assert(frames() > 0);
  const Description& description = *start_.description;
  DescribedScenario scenario;
  scenario.name = name;
  scenario.core = description.core;
  scenario.parameters = given(description.parameters, start_.parameters);
  scenario.inputs = given(description.inputs, start_.inputs);
  scenario.start = given(description.state, start_.row.state);
  scenario.clock.base = frame_times(rows_, row_bytes_);
  if (start_.is_held) scenario.events.push_back({std::int64_t{0}, Hold{}});
  for (const DescribedEvent& input : inputs_)
    if (std::get<std::int64_t>(input.when) < frames()) scenario.events.push_back(input);
  scenario.expect.emplace().state_hash = hex(hash_of_rows(rows_, row_bytes_));
  return scenario;
}

namespace {

std::shared_ptr<const Description> named(Description description, std::string_view core_name) {
  description.core = core_name;
  return std::make_shared<const Description>(std::move(description));
}

bool may_be_in_files(const ValueInfo& value, Word word) {
  if (value.type == ValueType::boolean) return true;
  const auto [low, high] = file_limits(value);
  return (!is_floating(value.type) || is_finite(word)) && !is_less(value.type, word, low) &&
         !is_less(value.type, high, word);
}

// Throws a sentence where a scenario cannot have one of them.
std::vector<GivenValue> changes(const ValueList& list, const std::vector<Word>& before,
                                const std::vector<Word>& now) {
  std::vector<GivenValue> changed;
  for (std::size_t place = 0; place < now.size(); ++place) {
    if (now[place] == before[place]) continue;
    if (!may_be_in_files(list.values[place], now[place]))
      throw std::out_of_range(list.values[place].name + " has a value that no scenario may have");
    changed.emplace_back(place, now[place]);
  }
  return changed;
}

std::vector<Word> initial_words(const ValueList& list) {
  std::vector<Word> words;
  for (const ValueInfo& value : list.values) words.push_back(value.initial);
  return words;
}

}  // namespace

MomentRecorder::MomentRecorder(const std::string& path, Description description, std::string_view core_name)
    : MomentRecorder(path, named(std::move(description), core_name)) {}

MomentRecorder::MomentRecorder(const std::string& path, std::shared_ptr<const Description> description)
    : ProgramRecorder(path,
                      [description](const DescribedScenario& scenario) {
                        return to_text(to_json(*description, scenario), 1) + "\n";
                      }),
      description_(std::move(description)) {}

void MomentRecorder::begin(const ReadMoment& read) {
  end_if_it_throws([&] {
    last_ = read(*description_);
    for (const auto& [list, words] : {std::pair(&description_->state, &last_.row.state),
                                      {&description_->inputs, &last_.inputs},
                                      {&description_->parameters, &last_.parameters}})
      static_cast<void>(changes(*list, initial_words(*list), *words));
    start(last_);
  });
}

void MomentRecorder::begin_frame(const ReadMoment& read) {
  if (!is_recording()) return;
  end_if_it_throws([&] {
    const CoreMoment now = read(*description_);
    if (!(now.row.dt_s >= 0.0 && now.row.dt_s <= kFrameMax_s))
      throw std::out_of_range("a dt that no scenario may have");
    if (now.parameters != last_.parameters) throw std::runtime_error("a parameter changed");
    if (now.is_held && !last_.is_held) add_input(Hold{});
    SetValues set{changes(description_->inputs, last_.inputs, now.inputs),
                  changes(description_->state, last_.row.state, now.row.state)};
    if (!set.inputs.empty() || !set.state.empty()) add_input(std::move(set));
    if (!now.is_held && last_.is_held) add_input(Go{});
  });
}

void MomentRecorder::end_frame(const ReadMoment& read) {
  if (!is_recording()) return;
  end_if_it_throws([&] {
    last_ = read(*description_);
    add_frame(last_);
    for (std::size_t place = 0; place < last_.row.state.size(); ++place) {
      const ValueInfo& value = description_->state.values[place];
      if (is_floating(value.type) && !is_finite(last_.row.state[place]))
        throw std::out_of_range(value.name + " is not finite");
    }
  });
}

void MomentRecorder::end_if_it_throws(const std::function<void()>& work) {
  if (const auto thrown = thrown_by(work)) stop(*thrown);
}

}  // namespace hyrax
