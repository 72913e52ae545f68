// The places of a run that a reader of its summary looks for.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "sim/trajectory/row_sink.h"

namespace hyrax {

struct Waypoints {
  static constexpr std::size_t kSecondsMax = 10;

  Row apex;                     ///< The highest row; the first of several.
  std::vector<Row> at_seconds;  ///< Entry k: the last row up to t = k + 1 s, as far as the run goes.
};

/// Finds the waypoints of a run as it is played.
class WaypointMeter final : public RowSink {
 public:
  /// @param steps of the run: rows of a short run, blocks of a long one, as RunRecorder wants them.
  explicit WaypointMeter(std::int64_t steps) : steps_(steps) {}

  [[nodiscard]] Wants wants() const override;
  void row(const Row& row) override;
  void block(const Block& block, std::int64_t count) override;

  /// At the end of the run. REQUIRES: it had a row.
  [[nodiscard]] Waypoints take();

 private:
  [[nodiscard]] bool has_all_seconds() const { return found_.at_seconds.size() == Waypoints::kSecondsMax; }
  // Whether a row at t_s, after a frame of dt_s, comes after the next second; times have the allowance of
  // `at_s`.
  [[nodiscard]] bool is_past_next_second(double t_s, double dt_s) const {
    return t_s > static_cast<double>(found_.at_seconds.size() + 1) + 1e-9 * dt_s;
  }
  void add_repetitions(const Block& block, std::int64_t count);

  std::int64_t steps_;
  Waypoints found_;
  std::optional<Row> last_;
};

}  // namespace hyrax
