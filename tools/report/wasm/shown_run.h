// A run as the page plays it: what is drawn, and what of the file it is held to.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim/reference/drift_meter.h"
#include "sim/reference/energy_causes.h"
#include "sim/replay/replay.h"

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
  void rows(const Columns& batch) override;
  void contact_began(const Contact& contact) override;
  void contact_ended(std::int64_t index, std::int64_t last_step) override;

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

  [[nodiscard]] Wants wants() const override;
  void rows(const Columns& batch) override;
  void block(const Block& block, std::int64_t count) override;

  /// The first row that differs; of a block of which no row is known, its first.
  [[nodiscard]] std::optional<std::int64_t> first_difference() const;
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
class ShownDrift final : public DriftSink {
 public:
  struct CausePoint {
    std::int64_t step = 0;
    EnergyCauses causes;
  };

  [[nodiscard]] bool wants_rows() const override { return true; }
  void row(const RowErrors& row) override { rows_.push_back(row); }
  void arc(const ArcErrors& arc) override {
    causes_.push_back({arc.first_step, sum_.now()});
    sum_.add(arc);
    causes_.push_back({arc.last_step, sum_.now()});
  }
  void contact(const ImpactErrors& contact) override {
    contacts_.push_back(contact);
    sum_.add(contact);
    causes_.push_back({contact.step, sum_.now()});
  }

  [[nodiscard]] const std::vector<RowErrors>& rows() const { return rows_; }
  [[nodiscard]] const std::vector<ImpactErrors>& contacts() const { return contacts_; }
  [[nodiscard]] const std::vector<CausePoint>& causes() const { return causes_; }

 private:
  EnergyCauseSum sum_{Model{}.gravity_px_per_s2};
  std::vector<RowErrors> rows_;
  std::vector<ImpactErrors> contacts_;
  std::vector<CausePoint> causes_;
};

class ShownRun {
 public:
  /// Longer runs are not measured against the reference.
  static constexpr std::int64_t kStepsMeasuredMax = 200'000;

  ShownRun(const Core& core, const Scenario& scenario, FileEvidence evidence);

  [[nodiscard]] std::int64_t steps() const { return replay_.steps(); }
  /// Plays up to row `step`; returns the row reached, which is less if the state became non-finite.
  std::int64_t play_to(std::int64_t step);
  void finish();

  [[nodiscard]] const ShownRows& shown() const { return shown_; }
  [[nodiscard]] const EvidenceCheck& check() const { return check_; }
  [[nodiscard]] const ShownDrift& drift() const { return drift_; }
  /// REQUIRES: finish() was called.
  [[nodiscard]] const RunSummary& summary() const { return summary_; }
  /// Nothing in it of a run that is not measured. REQUIRES: finish() was called.
  [[nodiscard]] const DriftSummary& errors() const { return errors_; }

 private:
  [[nodiscard]] std::vector<RowSink*> sinks();

  Scenario scenario_;
  ShownRows shown_;
  EvidenceCheck check_;
  ShownDrift drift_;
  std::optional<DriftMeter> meter_;
  Replay replay_;
  RunSummary summary_;
  DriftSummary errors_;
};

}  // namespace hyrax
