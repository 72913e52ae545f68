#include "tools/recorder/core_tape.h"

#include <cassert>

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

}  // namespace hyrax
