// A run as the page plays it: what is drawn, and what of the file it is held to.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "sim/reference/drift.h"
#include "sim/reference/drift_meter.h"
#include "sim/replay/replay.h"
#include "sim/scenario/frame_clock.h"
#include "sim/scenario/schedule.h"

namespace hyrax {

/// A file's rows and block digests, which the replay must give again bit for bit.
struct FileEvidence {
  Columns rows;                ///< In order of steps, any of them.
  std::vector<Digest> blocks;  ///< Of every block of the run, or none.
};

/// The rows that are drawn: all of a run of up to kRowsShownMax, of a longer one every K-th.
class ShownRows final : public RowSink {
 public:
  static constexpr std::int64_t kRowsShownMax = 1'000'000;
  static constexpr std::size_t kContactsShownMax = 10'000;

  explicit ShownRows(std::int64_t steps) : every_(1 + steps / kRowsShownMax) {}

  [[nodiscard]] Wants wants() const override { return {.rows_every = every_, .contacts = true}; }
  void row(const Row& row) override { columns_.append(row); }
  void contact_began(const Contact& contact) override {
    if (contacts_.size() < kContactsShownMax) contacts_.push_back(contact);
  }
  void contact_ended(std::int64_t index, std::int64_t last_step) override {
    if (static_cast<std::size_t>(index) < contacts_.size())
      contacts_[static_cast<std::size_t>(index)].last_step = last_step;
  }

  [[nodiscard]] std::int64_t every() const { return every_; }
  [[nodiscard]] const Columns& columns() const { return columns_; }
  [[nodiscard]] const std::vector<Contact>& contacts() const { return contacts_; }

 private:
  std::int64_t every_;
  Columns columns_;
  std::vector<Contact> contacts_;
};

/// Holds a replay to the rows and block digests of a file.
class EvidenceCheck final : public RowSink {
 public:
  explicit EvidenceCheck(FileEvidence evidence) : evidence_(std::move(evidence)) {}

  [[nodiscard]] Wants wants() const override {
    return {.rows_every = next_row_ < evidence_.rows.size() ? 1 : 0, .blocks = !evidence_.blocks.empty()};
  }
  void row(const Row& row) override {
    if (next_row_ == evidence_.rows.size()) return;
    const Row kept = evidence_.rows.row(next_row_);
    if (row.step < kept.step) return;
    if (!row_ && !same_bits(kept, row)) row_ = kept.step;
    ++next_row_;
  }
  void block(const Block& block, std::int64_t count) override {
    for (; count > 0 && next_block_ < evidence_.blocks.size(); --count, ++next_block_)
      if (!block_ && evidence_.blocks[next_block_] != block.digest)
        block_ = static_cast<std::int64_t>(next_block_ * kBlockRows);
  }

  /// The first row that differs; of a block of which no row is known, its first.
  [[nodiscard]] std::optional<std::int64_t> first_difference() const {
    if (!row_ || !block_) return row_ ? row_ : block_;
    // A row of the block that differs says more than the block.
    return *row_ < *block_ + static_cast<std::int64_t>(kBlockRows) ? row_ : block_;
  }
  [[nodiscard]] std::int64_t rows_compared() const { return static_cast<std::int64_t>(next_row_); }
  /// Whether every row and block of the file was played.
  [[nodiscard]] bool is_complete() const {
    return next_row_ == evidence_.rows.size() && next_block_ == evidence_.blocks.size();
  }

 private:
  FileEvidence evidence_;
  std::size_t next_row_ = 0;
  std::size_t next_block_ = 0;
  std::optional<std::int64_t> row_;
  std::optional<std::int64_t> block_;
};

/// What the reference says of the run: errors of every row of an arc and of contacts, and the causes of
/// energy drift at the ends of arcs and at contacts, in order of steps.
struct ShownDrift final : DriftSink {
  struct CausePoint {
    std::int64_t step = 0;
    EnergyCauses causes;
  };

  [[nodiscard]] bool wants_rows() const override { return true; }
  void row(const RowErrors& row) override { rows.push_back(row); }
  void arc(const ArcErrors& arc) override {
    causes.push_back({arc.first_step, sum.now()});
    sum.add(arc.energy_parts);
    causes.push_back({arc.last_step, sum.now()});
  }
  void contact(const ImpactErrors& contact) override {
    contacts.push_back(contact);
    sum.add(contact);
    causes.push_back({contact.step, sum.now()});
  }

  explicit ShownDrift(double gravity_px_per_s2) : sum{gravity_px_per_s2} {}

  EnergyCauseSum sum;
  std::vector<RowErrors> rows = {};
  std::vector<ImpactErrors> contacts = {};
  std::vector<CausePoint> causes = {};
};

struct ShownRun {
  /// Longer runs are not measured against the reference.
  static constexpr std::int64_t kStepsMeasuredMax = 200'000;

  /// @param model by which it is measured; nothing: it is not.
  ShownRun(const Core& core, const Scenario& played, const std::optional<Model>& model, FileEvidence evidence)
      : scenario(played),
        shown(step_count(scenario)),
        check(std::move(evidence)),
        drift(model.value_or(Model()).gravity_px_per_s2),
        replay(core, scenario, sinks(model)) {}

  /// Plays up to row `step`; returns the row reached, which is less if the state became non-finite.
  std::int64_t play_to(std::int64_t step) {
    replay.play_to(std::min(step, replay.steps()));
    return replay.keyframe().row.step;
  }
  void finish() {
    summary = replay.finish();
    if (meter) errors = meter->finish();
  }
  [[nodiscard]] std::vector<RowSink*> sinks(const std::optional<Model>& model) {
    std::vector<RowSink*> all = {&shown, &check};
    const std::int64_t steps = step_count(scenario);
    if (model && steps <= kStepsMeasuredMax)
      all.push_back(&meter.emplace(scenario, inputs_of(scenario, steps), drift, nullptr, *model));
    return all;
  }

  Scenario scenario;
  ShownRows shown;
  EvidenceCheck check;
  ShownDrift drift;
  std::optional<DriftMeter> meter;
  Replay replay;
  RunSummary summary;   ///< Once it is finished.
  DriftSummary errors;  ///< Once it is finished; empty of a run that is not measured.
};

}  // namespace hyrax
