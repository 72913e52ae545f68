#include "sim/described/described_run.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/described/scripted_body.h"
#include "sim/trajectory/row.h"

namespace hyrax {
namespace {

// A row is hashed with others at once.
constexpr std::size_t kHashedBytes = std::size_t{1} << 16;

std::size_t packed_bytes(const DescribedRow& row) {
  return (1 + row.state.size()) * sizeof(Word) + (row.contacts.size() + 7) / 8;
}

// Takes the row by value: what is written could be a part of it for all that the compiler knows.
void pack(DescribedRow row, std::byte* at) {
  store_little_endian(at, row.dt_s);
  for (const Word word : row.state) store_little_endian(at += sizeof(Word), std::bit_cast<double>(word));
  at += sizeof(Word);
  std::fill_n(at, (row.contacts.size() + 7) / 8, std::byte{0});
  for (std::size_t flag = 0; flag < row.contacts.size(); ++flag)
    if (row.contacts[flag] != 0) at[flag / 8] |= std::byte{1} << (flag % 8);
}

bool is_finite(Word floating) {
  constexpr Word kExponent = 0x7ff0000000000000;
  return (floating & kExponent) != kExponent;
}

class DescribedPlayer {
 public:
  DescribedPlayer(const FrameScript& script, std::span<DescribedSink* const> sinks)
      : script_(script), description_(script.core.description), sinks_(sinks) {
    row_.state.resize(description_.state.values.size());
    row_.outputs.resize(description_.outputs.values.size());
    row_.contacts.resize(description_.contacts.size());
    row_.properties.resize(description_.properties.size());
    summary_.final = row_.state;
    summary_.contacts.resize(description_.contacts.size());
    open_contacts_.resize(description_.contacts.size());
    for (const PropertyInfo& property : description_.properties)
      summary_.properties.push_back({property.is_always, {}});
    for (std::size_t place = 0; place < description_.state.values.size(); ++place) {
      const ValueInfo& value = description_.state.values[place];
      if (is_floating(value.type)) floating_.push_back(place);
      if (value.unit == "px") positions_.push_back({place, value.type, 0.0});
    }
  }

  DescribedSummary play() {
    while (next_row_ <= script_.steps && !summary_.early_end && make_row()) pass_row_on();
    finish();
    return std::move(summary_);
  }

 private:
  struct Row {
    std::vector<Word> state = {};
    std::vector<Word> outputs = {};
    std::vector<std::uint8_t> contacts = {};
    std::vector<std::uint8_t> properties = {};
  };
  struct OpenContact {
    DescribedContact contact = {};
    bool is_open = false;
    bool is_passed_on = false;
  };
  struct Anchored {
    std::size_t place = 0;
    ValueType type = ValueType::float64;
    double anchor = 0.0;
  };

  /// All that calls the core: whether there is a further row.
  bool make_row() {
    const std::optional<std::string> thrown = thrown_by([&] {
      if (!body_)
        body_.emplace(script_);
      else
        body_->play_frame();
      DescribedBody& body = body_->body();
      body.read(SettableList::state, row_.state);
      if (!row_.outputs.empty()) body.outputs(row_.outputs);
      body_->contacts(row_.contacts);
      if (!row_.properties.empty()) body.properties(row_.properties);
      if (rows_in_block_ == 0) {
        block_.keyframe.inputs.resize(description_.inputs.values.size());
        body.read(SettableList::inputs, block_.keyframe.inputs);
      }
    });
    if (thrown) summary_.early_end = {next_row_, *thrown, false};
    return !thrown;
  }

  void pass_row_on() {
    if (next_row_ > 0) timeline_.play(body_->dt_s());
    const DescribedRow row = {.step = next_row_,
                              .t_s = timeline_.time_s(),
                              .dt_s = body_->dt_s(),
                              .state = row_.state,
                              .outputs = row_.outputs,
                              .contacts = row_.contacts};
    hash(row);
    for (DescribedSink* sink : sinks_) sink->row(row);
    follow_contacts(row);
    follow_properties(row);
    follow_rest(row);
    for (const std::size_t place : floating_)
      if (!is_finite(row.state[place]) && !summary_.early_end)
        summary_.early_end = {row.step, description_.state.values[place].name + " is not finite", true};
    std::swap(summary_.final, row_.state);
    summary_.steps = next_row_++;
    summary_.simulated_s = row.t_s;
  }

  void hash(const DescribedRow& row) {
    if (rows_in_block_ == 0) {
      block_.keyframe.step = row.step;
      block_.keyframe.timeline = timeline_;
      block_.keyframe.state.assign(row.state.begin(), row.state.end());
      block_.keyframe.is_held = body_->is_held();
    }
    const std::size_t size = packed_bytes(row);
    bytes_.resize(kHashedBytes + size);
    pack(row, bytes_.data() + packed_);
    packed_ += size;
    if (packed_ > kHashedBytes) hash_packed();
    if (++rows_in_block_ == kBlockRows) close_block();
  }

  void hash_packed() {
    block_hash_.add(std::span(bytes_).first(packed_));
    packed_ = 0;
  }
  void close_block() {
    hash_packed();
    block_.digest = std::exchange(block_hash_, ByteHash()).value();
    rows_in_block_ = 0;
    hash_.add(block_.digest);
    for (DescribedSink* sink : sinks_) sink->block(block_);
  }

  void follow_contacts(const DescribedRow& row) {
    for (std::size_t place = 0; place < open_contacts_.size(); ++place) {
      OpenContact& open = open_contacts_[place];
      const bool is_on = row.contacts[place] != 0;
      if (is_on && !open.is_open) {
        ++summary_.contacts[place];
        open = {{place, row.step, row.step, row.t_s}, true, contacts_begun_++ < kContactsRecordedMax};
      }
      if (is_on) open.contact.last_step = row.step;
      if (!is_on) end_contact(open);
    }
  }
  void end_contact(OpenContact& open) {
    if (open.is_open && open.is_passed_on)
      for (DescribedSink* sink : sinks_) sink->contact(open.contact);
    open.is_open = false;
  }

  void follow_properties(const DescribedRow& row) {
    for (std::size_t place = 0; place < row_.properties.size(); ++place) {
      PropertyOutcome& outcome = summary_.properties[place];
      const bool holds = row_.properties[place] != 0;
      if (outcome.step || holds == outcome.holds) continue;
      outcome = {holds, row.step, row.t_s};
    }
  }

  void follow_rest(const DescribedRow& row) {
    const auto number = [&](const Anchored& position) {
      return number_of(position.type, row.state[position.place]);
    };
    constexpr double kRestRadius_px = 0.5;
    if (row.step > 0 && std::none_of(positions_.begin(), positions_.end(), [&](const Anchored& position) {
          return std::fabs(number(position) - position.anchor) > kRestRadius_px;
        }))
      return;
    for (Anchored& position : positions_) position.anchor = number(position);
    anchor_t_s_ = row.t_s;
  }

  void finish() {
    if (rows_in_block_ > 0) close_block();
    for (OpenContact& open : open_contacts_) end_contact(open);
    if (!positions_.empty() && summary_.simulated_s - anchor_t_s_ >= 1.0)
      summary_.at_rest_since_s = anchor_t_s_;
    summary_.state_hash = hash_.value();
    const DescribedScenario& scenario = script_.scenario;
    summary_.inputs_set.resize(description_.inputs.values.size());
    summary_.actions_done.resize(description_.actions.size());
    const auto mark = [&](const std::vector<GivenValue>& given) {
      for (const auto& [place, word] : given) summary_.inputs_set[place] = 1;
    };
    mark(scenario.inputs);
    for (const InputArray& array : scenario.input_arrays) summary_.inputs_set[array.input] = 1;
    for (std::size_t event = 0; event < scenario.events.size(); ++event) {
      if (script_.event_frames[event] >= summary_.steps) continue;
      if (const auto* values = std::get_if<SetValues>(&scenario.events[event].action)) mark(values->inputs);
      if (const auto* act = std::get_if<Act>(&scenario.events[event].action))
        summary_.actions_done[act->action] = 1;
    }
  }

  const FrameScript& script_;
  const Description& description_;
  std::span<DescribedSink* const> sinks_;
  std::optional<ScriptedBody> body_ = {};
  std::int64_t next_row_ = 0;
  Row row_ = {};
  Timeline timeline_ = {};
  std::vector<std::size_t> floating_ = {};
  std::vector<Anchored> positions_ = {};  // All values in px.
  double anchor_t_s_ = 0.0;
  std::vector<OpenContact> open_contacts_ = {};
  std::int64_t contacts_begun_ = 0;
  std::vector<std::byte> bytes_ = {};  // Of rows that are not hashed yet, as many as packed_.
  std::size_t packed_ = 0;
  ByteHash block_hash_ = {};
  StateHash hash_ = {};
  std::size_t rows_in_block_ = 0;
  DescribedBlock block_ = {};
  DescribedSummary summary_ = {};
};

}  // namespace

DescribedSummary play(const DescribedCore& core, const DescribedScenario& scenario,
                      std::span<DescribedSink* const> sinks) {
  return DescribedPlayer(FrameScript(core, scenario), sinks).play();
}

void pack_row(const DescribedRow& row, std::vector<std::byte>& bytes) {
  const std::size_t begin = bytes.size();
  bytes.resize(begin + packed_bytes(row));
  pack(row, bytes.data() + begin);
}

}  // namespace hyrax
