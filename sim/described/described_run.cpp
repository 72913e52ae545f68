#include "sim/described/described_run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "sim/described/scripted_body.h"
#include "sim/trajectory/row.h"

namespace hyrax {
namespace {

// Made and passed on at once: few enough to stay in the cache.
constexpr std::size_t kRowsAtOnce = 256;

std::size_t packed_bytes(std::size_t values, std::size_t contacts) {
  return (1 + values) * sizeof(Word) + (contacts + 7) / 8;
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

class DescribedPlayer {
 public:
  DescribedPlayer(const FrameScript& script, std::span<DescribedSink* const> sinks)
      : script_(script), description_(script.core.description), sinks_(sinks) {
    rows_.words.resize(kRowsAtOnce * (1 + width_));
    rows_.outputs.resize(kRowsAtOnce * description_.outputs.values.size());
    rows_.contacts.resize(kRowsAtOnce * description_.contacts.size());
    rows_.properties.resize(kRowsAtOnce * description_.properties.size());
    summary_.final.resize(width_);
    summary_.contacts.resize(description_.contacts.size());
    open_contacts_.resize(description_.contacts.size());
    for (const PropertyInfo& property : description_.properties)
      summary_.properties.push_back({property.is_always, {}});
    for (std::size_t place = 0; place < description_.state.values.size(); ++place) {
      const ValueInfo& value = description_.state.values[place];
      if (is_floating(value.type)) floating_.push_back(place);
      if (value.unit == "px") positions_.push_back({place, value.type});
    }
  }

  DescribedSummary play() {
    while (next_row_ <= script_.steps && !summary_.early_end) {
      make_rows();
      pass_rows_on();
    }
    finish();
    return std::move(summary_);
  }

 private:
  struct OpenContact {
    DescribedContact contact = {};
    bool is_open = false;
    bool is_passed_on = false;
  };
  struct Position {
    std::size_t place = 0;
    ValueType type = ValueType::float64;
  };

  /// All that calls the core. The first row of a block is made alone, as its keyframe has the inputs of it.
  void make_rows() {
    const bool begins_block = rows_in_block_ == 0;
    rows_.count = 0;
    const std::optional<std::string> thrown = thrown_by([&] {
      if (!body_) {
        body_.emplace(script_);
        rows_.dt_s.assign(1, 0.0);
        body_->body().add_row(false, rows_);
      } else {
        body_->play_frames(
            static_cast<std::int64_t>(begins_block ? 1 : std::min(kRowsAtOnce, kBlockRows - rows_in_block_)),
            rows_);
      }
      if (!begins_block) return;
      block_.keyframe.inputs.resize(description_.inputs.values.size());
      body_->body().read(SettableList::inputs, block_.keyframe.inputs);
    });
    if (!thrown) return;
    if (begins_block) rows_.count = 0;
    summary_.early_end = {next_row_ + static_cast<std::int64_t>(rows_.count), *thrown, false};
  }

  void pass_rows_on() {
    end_at_first_non_finite();
    if (rows_.count == 0) return;
    follow_time();
    hash_rows();
    for (DescribedSink* sink : sinks_)
      for (std::size_t place = 0; place < rows_.count; ++place) sink->row(row(place));
    follow_contacts();
    follow_properties();
    follow_rest();
    next_row_ += static_cast<std::int64_t>(rows_.count);
    const std::span<const Word> last = row(rows_.count - 1).state;
    summary_.final.assign(last.begin(), last.end());
    summary_.steps = next_row_ - 1;
    summary_.simulated_s = times_s_[rows_.count - 1];
  }

  /// One of those that were made. REQUIRES: place < rows_.count.
  DescribedRow row(std::size_t place) const {
    const auto part = [&](const auto& list, std::size_t width) {
      return std::span(list).subspan(place * width, width);
    };
    return {.step = next_row_ + static_cast<std::int64_t>(place),
            .t_s = times_s_[place],
            .dt_s = rows_.dt_s[place],
            .state = part(rows_.words, 1 + width_).subspan(1),
            .outputs = part(rows_.outputs, description_.outputs.values.size()),
            .contacts = part(rows_.contacts, open_contacts_.size())};
  }

  /// Rows of equal dt at once.
  void follow_time() {
    std::size_t place = 0;
    if (next_row_ == 0) times_s_[place++] = timeline_.time_s();
    while (place < rows_.count) {
      const double dt_s = rows_.dt_s[place];
      timeline_.play(dt_s, 0);
      const std::size_t first = place;
      for (; place < rows_.count && same_bits(rows_.dt_s[place], dt_s); ++place)
        times_s_[place] = timeline_.time_s(static_cast<std::int64_t>(place - first) + 1);
      timeline_.play(dt_s, static_cast<std::int64_t>(place - first));
    }
  }

  void end_at_first_non_finite() {
    if (rows_.all_are_finite) return;
    for (std::size_t place = 0; place < rows_.count; ++place)
      for (const std::size_t value : floating_) {
        if (is_finite(row(place).state[value])) continue;
        summary_.early_end = {next_row_ + static_cast<std::int64_t>(place),
                              description_.state.values[value].name + " is not finite", true};
        rows_.count = place + 1;
        return;
      }
  }

  void hash_rows() {
    if (rows_in_block_ == 0) {
      const DescribedRow first = row(0);
      block_.keyframe.step = first.step;
      block_.keyframe.timeline = timeline_;
      block_.keyframe.state.assign(first.state.begin(), first.state.end());
      block_.keyframe.is_held = body_->is_held();
    }
    if (std::endian::native == std::endian::little && open_contacts_.empty()) {
      block_hash_.add(std::as_bytes(std::span(rows_.words).first(rows_.count * (1 + width_))));
    } else {
      std::byte* at = bytes_.data();
      for (std::size_t place = 0; place < rows_.count; ++place, at += row_bytes_) pack(row(place), at);
      block_hash_.add(std::span(bytes_).first(rows_.count * row_bytes_));
    }
    rows_in_block_ += rows_.count;
    if (rows_in_block_ == kBlockRows) close_block();
  }

  void close_block() {
    block_.digest = std::exchange(block_hash_, ByteHash()).value();
    rows_in_block_ = 0;
    hash_.add(block_.digest);
    for (DescribedSink* sink : sinks_) sink->block(block_);
  }

  void follow_contacts() {
    if (open_contacts_.empty()) return;
    for (std::size_t place = 0; place < rows_.count; ++place)
      for (std::size_t contact = 0; contact < open_contacts_.size(); ++contact)
        follow_contact(contact, row(place));
  }
  void follow_contact(std::size_t contact, const DescribedRow& row) {
    OpenContact& open = open_contacts_[contact];
    const bool is_on = row.contacts[contact] != 0;
    if (is_on && !open.is_open) {
      ++summary_.contacts[contact];
      open = {{contact, row.step, row.step, row.t_s}, true, contacts_begun_++ < kContactsRecordedMax};
    }
    if (is_on) open.contact.last_step = row.step;
    if (!is_on) end_contact(open);
  }
  void end_contact(OpenContact& open) {
    if (open.is_open && open.is_passed_on)
      for (DescribedSink* sink : sinks_) sink->contact(open.contact);
    open.is_open = false;
  }

  void follow_properties() {
    const std::size_t properties = summary_.properties.size();
    for (std::size_t flag = 0; flag < rows_.count * properties; ++flag) {
      PropertyOutcome& outcome = summary_.properties[flag % properties];
      const bool holds = rows_.properties[flag] != 0;
      if (outcome.step || holds == outcome.holds) continue;
      const std::size_t place = flag / properties;
      outcome = {holds, next_row_ + static_cast<std::int64_t>(place), times_s_[place]};
    }
  }

  void follow_rest() {
    if (positions_.empty()) return;
    const bool all_are_doubles =
        std::all_of(positions_.begin(), positions_.end(),
                    [](const Position& position) { return position.type == ValueType::float64; });
    if (all_are_doubles)
      follow_rest([](ValueType /*type*/, Word word) { return std::bit_cast<double>(word); });
    else
      follow_rest(number_of);
  }
  /// @param number of a word.
  void follow_rest(const auto& number) {
    constexpr double kRestRadius_px = 0.5;
    const Word* anchor = anchor_.data();
    const Word* state = rows_.words.data() + 1;
    for (std::size_t row = 0; row < rows_.count; ++row, state += 1 + width_) {
      const auto is_away = [&](const Position& position) {
        return std::fabs(number(position.type, state[position.place]) -
                         number(position.type, anchor[position.place])) > kRestRadius_px;
      };
      if ((next_row_ > 0 || row > 0) && std::none_of(positions_.begin(), positions_.end(), is_away)) continue;
      anchor = state;
      anchor_t_s_ = times_s_[row];
    }
    if (anchor != anchor_.data()) anchor_.assign(anchor, anchor + width_);
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
  const std::size_t width_ = description_.state.values.size();
  MadeRows rows_ = {};
  std::array<double, kRowsAtOnce> times_s_ = {};
  Timeline timeline_ = {};
  std::vector<std::size_t> floating_ = {};
  std::vector<Position> positions_ = {};  // All values in px.
  std::vector<Word> anchor_ = {};         // The last state that was away from the one before.
  double anchor_t_s_ = 0.0;
  std::vector<OpenContact> open_contacts_ = {};
  std::int64_t contacts_begun_ = 0;
  const std::size_t row_bytes_ = packed_bytes(width_, description_.contacts.size());
  std::vector<std::byte> bytes_ = std::vector<std::byte>(kRowsAtOnce * row_bytes_);
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
  bytes.resize(begin + packed_bytes(row.state.size(), row.contacts.size()));
  pack(row, bytes.data() + begin);
}

}  // namespace hyrax
