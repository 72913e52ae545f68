// Cuts a run into flight arcs as its rows come in.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "sim/motion/state.h"
#include "sim/scenario/scenario.h"
#include "sim/trajectory/input_playback.h"
#include "sim/trajectory/row_sink.h"

namespace hyrax {

/// Why an arc goes no further: a clamp, by kWalls (in a corner the wall in x), an input, a grab, or the run.
enum class ArcEnd { left, right, top, ground, input, hold, end };

inline constexpr std::array<std::string_view, 7> kArcEndNames = {"left",  "right", "top", "ground",
                                                                 "input", "hold",  "end"};

/// The wall that ended an arc; none where an input, a grab or the run's end did.
[[nodiscard]] std::optional<Wall> wall_of(ArcEnd end);

/// The state an arc begins with: a row's, after the inputs of the next frame.
struct ArcStart {
  Row row;
  Bounds bounds;  ///< In force.
};

/// Receives arcs of two steps and more, one after the other, and the short ones between them.
class ArcVisitor {
 public:
  ArcVisitor() = default;
  ArcVisitor(const ArcVisitor&) = delete;
  ArcVisitor& operator=(const ArcVisitor&) = delete;
  virtual ~ArcVisitor() = default;

  virtual void begin(const ArcStart& start) = 0;
  /// A row reached without clamp, input or hold: the start's step + 1, + 2, ...
  virtual void fly(const Row& row) = 0;
  /// @param clamped the row that the wall's clamp made, null where no wall ended the arc.
  virtual void end(ArcEnd ended_by, const Row* clamped) = 0;
  /// An arc of fewer than two steps: of one, `flown`, or of none where the frame after the start is clamped.
  /// Each may be null, not both. The walls of the start's own row go on clamping, if they clamp again at
  /// once.
  virtual void short_arc(const ArcStart& start, const Row* flown, const Row* clamped) = 0;
};

/// Holds one row of an arc at most.
class ArcCutter final : public RowSink {
 public:
  /// @param inputs of the scenario, as they were applied. Refers to the visitor.
  ArcCutter(const Scenario& scenario, std::vector<Input> inputs, ArcVisitor& visitor);

  [[nodiscard]] Wants wants() const override { return {.rows_every = 1}; }
  /// Rows from row 0 on, every one, live or from a file.
  void row(const Row& row) override;
  /// Ends the arc that the run's last row leaves open.
  void finish();

  /// Its inputs are applied up to the frame after the last row.
  [[nodiscard]] const InputPlayback& playback() const { return playback_; }
  /// Arcs of fewer than two steps. An arc that no frame follows, at the run's last row, is none.
  [[nodiscard]] std::int64_t skipped_arcs() const { return skipped_arcs_; }
  /// The first row that is not finite (or beyond 1e100, or of a dt that no clock has); nothing from
  /// there on belongs to an arc.
  [[nodiscard]] std::optional<std::int64_t> non_finite_step() const { return non_finite_step_; }

 private:
  void fly(const Row& row);
  void close(ArcEnd ended_by, const Row* clamped);
  void open(const Row& start);

  InputPlayback playback_;
  ArcVisitor& visitor_;
  ArcStart start_;
  bool is_flying_ = false;
  std::int64_t steps_ = 0;  // Of the open arc.
  Row first_row_;           // Not handed on before a second one comes.
  std::int64_t skipped_arcs_ = 0;
  std::optional<std::int64_t> non_finite_step_;
};

}  // namespace hyrax
