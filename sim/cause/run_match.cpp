#include "sim/cause/run_match.h"

#include <algorithm>

#include "sim/compare/comparison.h"
#include "sim/replay/replay.h"

namespace hyrax {
namespace {

// Compares a replay with a run, by rows or by blocks, until one differs.
class RunMatcher final : public RowSink {
 public:
  explicit RunMatcher(const StoredRun& run) : run_(run) {}

  [[nodiscard]] Wants wants() const override {
    return {.rows_every = run_.blocks.empty() ? 1 : 0, .contacts = true, .blocks = !run_.blocks.empty()};
  }
  void rows(const Columns& batch) override {
    for (std::size_t index = 0; index < batch.size() && match_.rows; ++index, ++at_)
      take(at_ < run_.rows.size() ? run_.rows.row(at_) : Row{.step = -1}, batch.row(index));
  }
  void block(const Block& block, std::int64_t count) override {
    while (count > 0 && match_.rows) {
      match_.rows = at_ < run_.blocks.size() && run_.blocks[at_].digest == block.digest;
      if (!match_.rows) return;
      if (used_ == 0) match_.times &= same_bits(run_.blocks[at_].keyframe.row.t_s, block.keyframe.row.t_s);
      const std::int64_t both = std::min(count, run_.blocks[at_].count - used_);
      count -= both;
      used_ += both;
      if (used_ < run_.blocks[at_].count) return;
      ++at_;
      used_ = 0;
    }
  }
  void contact_began(const Contact& contact) override { contacts_.push_back(contact); }
  void contact_ended(std::int64_t index, std::int64_t last_step) override {
    contacts_[static_cast<std::size_t>(index)].last_step = last_step;
  }

  [[nodiscard]] bool differs() const { return !match_.rows; }
  RunMatch finish(const RunSummary& summary) {
    match_.rows &= summary.steps == run_.steps && hex(summary.state_hash) == run_.state_hash;
    match_.times &= same_bits(summary.final.t_s, run_.final.t_s);
    std::size_t next = 0;
    run_.each_contact([&](const Contact& contact) {
      match_.contacts &= next < contacts_.size() && is_same(contact, contacts_[next]);
      ++next;
    });
    match_.contacts &= next == contacts_.size() && summary.contacts.total() == run_.contacts_total;
    return match_;
  }

 private:
  void take(const Row& stored, const Row& played) {
    match_.rows = stored.step == played.step && same_bits(state_of(stored), state_of(played)) &&
                  same_bits(stored.dt_s, played.dt_s) && stored.contact == played.contact;
    match_.times &= same_bits(stored.t_s, played.t_s);
  }
  static bool is_same(const Contact& a, const Contact& b) {
    return a.step == b.step && a.last_step == b.last_step && a.wall == b.wall &&
           std::ranges::all_of(kContactFields,
                               [&](const ContactField& field) { return agrees(field, a, b); });
  }

  const StoredRun& run_;
  std::vector<Contact> contacts_;
  std::size_t at_ = 0;     // The row, or the block, that comes next,
  std::int64_t used_ = 0;  // and how many repetitions of the block there were.
  RunMatch match_{true, true, true};
};

bool is_hitch(const Input& input) { return std::holds_alternative<Hitch>(input.action); }

}  // namespace

Scenario playback_of(const StoredRun& golden) {
  Scenario playback = golden.scenario;
  playback.events.clear();
  const bool has_rows = golden.rows.size() > 1;
  for (const Input& input : golden.inputs)
    if (!has_rows || !is_hitch(input)) playback.events.push_back({input.frame, input.action});
  if (has_rows) {
    playback.clock = {RecordedSteps{{golden.rows.dt_s.begin() + 1, golden.rows.dt_s.end()}}, {}};
    playback.length = std::monostate();
    return playback;
  }
  if (const auto* const rate = std::get_if<FixedRate>(&playback.clock.base))
    playback.clock.base = FixedStep{1.0 / rate->rate_hz};
  playback.length = golden.steps;
  return playback;
}

RunMatch match(const Core& core, const Scenario& scenario, const StoredRun& run) {
  RunMatcher matcher(run);
  Replay replay(core, scenario, matcher);
  if (replay.steps() < run.steps) return {};
  std::int64_t piece = 16 * static_cast<std::int64_t>(kBlockRows);
  for (std::int64_t at = -1; at < run.steps && !matcher.differs(); piece *= 2) {
    if (replay.keyframe().row.step == at) break;  // The state is not finite any more.
    at = replay.keyframe().row.step;
    replay.play_to(std::min(run.steps, at + piece));
  }
  if (matcher.differs()) return {};
  return matcher.finish(replay.finish());
}

}  // namespace hyrax
