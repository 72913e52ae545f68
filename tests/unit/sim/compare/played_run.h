// Runs for the comparer: played, kept as a golden file keeps them, and played again with one fault.
#pragma once

#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "sim/compare/run_comparer.h"
#include "tests/unit/sim/replay/kept_run.h"
#include "tests/unit/sim/replay/some_flings.h"

namespace hyrax {

/// The fields that a fault can be put into; all are doubles except the contact byte.
inline const std::map<std::string_view, double Row::*> kFaultyFields = {
    {"t", &Row::t_s},  {"dt", &Row::dt_s},        {"x", &Row::x_px},
    {"y", &Row::y_px}, {"vx", &Row::vx_px_per_s}, {"vy", &Row::vy_px_per_s}};

/// The row with one field one ulp up, or one wall more or less in its contact byte.
inline Row with_fault(Row row, std::string_view field) {
  if (field == "contact")
    row.contact ^= static_cast<std::uint8_t>(Wall::top);
  else
    row.*kFaultyFields.at(field) =
        std::nextafter(row.*kFaultyFields.at(field), std::numeric_limits<double>::infinity());
  return row;
}

/// Such as "rounding, first x at 5, 1 ulps": the class, and what differs first.
inline std::string said(const Comparison& comparison) {
  std::string text = comparison.agrees ? "agrees" : std::string(name_of(comparison.difference.value()));
  if (!comparison.first) return text;
  text += ", first " + std::string(comparison.first->field) + " at " + std::to_string(comparison.first->step);
  return comparison.first->ulps() ? text + ", " + std::to_string(*comparison.first->ulps()) + " ulps" : text;
}

/// Of that fault in a row.
inline std::string said_of_fault(std::int64_t step, std::string_view field) {
  const std::string place = ", first " + std::string(field) + " at " + std::to_string(step);
  return field == "contact" ? "contacts" + place : "rounding" + place + ", 1 ulps";
}

/// A change of one row of a run before it reaches a sink.
struct Fault {
  std::int64_t step = 0;
  std::function<Row(const Row&)> change;
};

inline Fault one_ulp(std::int64_t step, std::string_view field) {
  return {step, [field = std::string(field)](const Row& row) { return with_fault(row, field); }};
}

/// The rows with a fault in that one.
inline RowBlock with_fault_at(const RowBlock& rows, std::int64_t faulty,
                              const std::function<Row(const Row&)>& change) {
  RowBlock changed;
  for (std::size_t index = 0; index < rows.size(); ++index) {
    changed.append(static_cast<std::int64_t>(index) == faulty ? change(rows.row(index)) : rows.row(index));
  }
  return changed;
}

/// Passes a run to a sink with one fault, as a replay with that fault would.
class FaultySink : public RowSink {
 public:
  FaultySink(RowSink& sink, Fault fault) : sink_(sink), fault_(std::move(fault)) {}

  [[nodiscard]] Wants wants() const override { return sink_.wants(); }
  void row(const Row& row) override { sink_.row(row.step == fault_.step ? fault_.change(row) : row); }
  void contact_began(const Contact& contact) override { sink_.contact_began(contact); }
  void contact_ended(std::int64_t index, std::int64_t last_step) override {
    sink_.contact_ended(index, last_step);
  }
  void block(const Block& block, std::int64_t count) override {
    const std::int64_t offset = fault_.step - block.keyframe.row.step;
    if (count != 1 || offset < 0 || offset >= static_cast<std::int64_t>(block.rows.size()))
      return sink_.block(block, count);
    const RowBlock changed = with_fault_at(block.rows, offset, fault_.change);
    Keyframe keyframe = block.keyframe;
    if (offset == 0) keyframe.row = fault_.change(keyframe.row);
    sink_.block({digest(changed), keyframe, changed}, 1);
  }

 private:
  RowSink& sink_;
  Fault fault_;
};

/// Plays a kept block again, as the program does.
inline RowBlock expand(const Scenario& scenario, const StoredBlock& kept) {
  struct TakeBlock : RowSink {
    Wants wants() const override { return {.blocks = true}; }
    void block(const Block& block, std::int64_t) override {
      if (rows.size() == 0) rows.append(block.rows, 0, block.rows.size());
    }
    RowBlock rows;
  } taken;
  Replay replay(shipped_core(), scenario, kept.keyframe, taken);
  replay.play_to(
      std::min(replay.steps(), kept.keyframe.row.step + static_cast<std::int64_t>(kBlockRows) - 1));
  static_cast<void>(replay.finish());
  return std::move(taken.rows);
}

/// How a run is played against a kept one.
struct Playing {
  std::optional<Fault> fault = {};
  bool can_expand = true;  ///< Else as with a changed core, which does not give the kept rows again.
  bool skips_repetition = true;
  std::string_view physics = kPhysicsModel;
  int other_walls = 0;
};

inline Comparison compare(const StoredRun& kept, const Scenario& scenario, const Playing& playing = {}) {
  RunComparer comparer(
      kept,
      [&](const StoredBlock& block) {
        RowBlock rows = expand(kept.scenario, block);
        return playing.can_expand ? std::move(rows) : with_fault_at(rows, 1, one_ulp(1, "vy").change);
      },
      playing.other_walls);
  const ReplayOptions options{.skips_repetition = playing.skips_repetition};
  RunSummary summary;
  if (playing.fault) {
    FaultySink faulty(comparer, *playing.fault);
    summary = replay(shipped_core(), scenario, faulty, options);
    if (playing.fault->step == summary.steps) summary.final = playing.fault->change(summary.final);
  } else {
    summary = replay(shipped_core(), scenario, comparer, options);
  }
  return comparer.finish(scenario, playing.physics, summary);
}

}  // namespace hyrax
