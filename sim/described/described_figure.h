// The picture of a run: the paths of its positions, and its other values over time.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/described/described_run.h"
#include "sim/result/figure.h"
#include "sim/result/table.h"

namespace hyrax {

/// Collects what the picture shows of a run: at most kPointsMax rows at even distances, and the first
/// contacts.
class DescribedPicture final : public DescribedSink {
 public:
  static constexpr std::size_t kPointsMax = 4'000;
  static constexpr std::size_t kContactsMax = 200;

  /// Refers to both.
  DescribedPicture(const Description& description, const DescribedScenario& scenario);

  void row(const DescribedRow& row) override;

  /// A path for each pair of positions with dots at contacts (one whose name has that of a pair, as a_floor,
  /// is of that pair; any other of all), in the frame of the inputs width_px and height_px if there are such;
  /// a plot for the other values and outputs of each unit, and for those of the same names of values; lines
  /// at actions and sets. @param subtitle what was found of the run. @param golden another run, whose curves
  /// are behind; of another description, and null: none.
  [[nodiscard]] Figure figure(const std::string& subtitle, const DescribedPicture* golden = nullptr) const;
  /// The rows that are drawn, state and outputs.
  [[nodiscard]] Table rows() const;

 private:
  struct Point {
    std::int64_t step = 0;
    double t_s = 0.0;
    std::vector<double> values = {};         // State, then outputs.
    std::vector<std::size_t> contacts = {};  // That begin in it, where that is known.
  };

  [[nodiscard]] Plot path_plot(const std::vector<PositionPair>& pairs, const DescribedPicture* golden) const;
  [[nodiscard]] std::vector<Plot> value_plots(const std::vector<PositionPair>& pairs,
                                              const DescribedPicture* golden) const;

  const Description& description_;
  const DescribedScenario& scenario_;
  std::int64_t every_ = 1;
  std::vector<Point> points_ = {};
  std::vector<Point> contacts_ = {};
  std::int64_t next_step_ = 0;  // In it a contact may begin: the row before is known.
  std::vector<std::uint8_t> flags_before_ = {};
  std::vector<std::int64_t> event_frames_;
  std::size_t next_event_ = 0;
  std::vector<Mark> marks_ = {};  // Actions and sets.
};

}  // namespace hyrax
