// Two runs of a core that describes itself.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sim/compare/comparison.h"
#include "sim/compare/expectations.h"
#include "sim/compare/trajectory_comparer.h"
#include "sim/described/described_run.h"

namespace hyrax {

/// Where two runs part.
struct DescribedDivergence {
  std::int64_t step = 0;
  double t_s = 0.0;      ///< In the first run.
  ValueInfo value = {};  ///< t, dt, of the state, or a contact's flag; "state" if only a digest is known.
  std::optional<Word> expected = {};
  std::optional<Word> actual = {};
  /// In the value's own type; nothing where it is not floating, or not known.
  [[nodiscard]] std::optional<std::uint64_t> ulps() const;
};

/// The largest difference of a value, within the tolerance or not.
struct DescribedWorst {
  ValueInfo value = {};
  std::int64_t step = 0;
  double abs = 0.0;
  std::optional<std::uint64_t> ulps = {};
};

/// A run, as it is compared.
struct ComparedSide {
  DescribedRowBatches rows = {};
  std::vector<std::int64_t> jumps = {};  ///< jump_frames.
  std::vector<DescribedContact> contacts = {};
};

struct DescribedComparison {
  std::optional<DifferenceClass> difference = {};  ///< Nothing: they agree.
  std::string shape = {};                          ///< What differs in shape, a sentence.
  std::optional<DescribedDivergence> first = {};
  ContactCounts contacts = {};
  bool has_px = false;  ///< Else no value is a distance.
  Distance distance = {};
  std::map<std::string, double> max = {};  ///< The largest difference of each unit of the state.
  std::vector<DescribedWorst> worst = {};  ///< Of t, dt and the state, by steps; none where no bit differs.

  [[nodiscard]] bool agrees() const { return !difference; }
  /// Nothing where it cannot be told.
  [[nodiscard]] std::optional<double> max_px() const {
    if (!has_px || (distance.has_unknown_rows && !distance.largest)) return std::nullopt;
    return distance.px();
  }
};

/// Compares rows of the same steps, and contacts; measures how far the runs are apart: by steps, or where a
/// frame has another dt at equal times.
/// @param tolerance of floating values.
[[nodiscard]] DescribedComparison compare_runs(const Description& description, const ComparedSide& a,
                                               const ComparedSide& b, const Tolerance& tolerance = {});

/// The same of runs of two descriptions, by the values of the state of one name and type, and the contacts of
/// one name, that both have.
[[nodiscard]] DescribedComparison compare_common(const Description& description_a, const ComparedSide& a,
                                                 const Description& description_b, const ComparedSide& b,
                                                 const Tolerance& tolerance = {});

/// Of two runs that are the same.
[[nodiscard]] DescribedComparison no_difference(const Description& description);

/// Runs of which only blocks are kept: the difference is in the first block of another digest. REQUIRES:
/// blocks in order, each a whole run.
[[nodiscard]] DescribedComparison compare_blocks(const Description& description,
                                                 const std::vector<DescribedBlock>& a,
                                                 const std::vector<DescribedBlock>& b);

/// How many contacts moved, vanished and appeared.
[[nodiscard]] ContactCounts contact_counts(std::vector<DescribedContact> a, std::vector<DescribedContact> b);

/// An event, and the frame that it is applied before.
struct TimedEvent {
  std::int64_t frame = 0;
  const DescribedAction* action = nullptr;
};
/// Those of the first `steps` frames; refers to the scenario.
[[nodiscard]] std::vector<TimedEvent> timed_events(const DescribedScenario& scenario, std::int64_t steps);

/// Frames with a `set`, an action, `hold` or `go`, which no straight line between two rows shows.
[[nodiscard]] std::vector<std::int64_t> jump_frames(const DescribedScenario& scenario, std::int64_t steps);

/// A verdict for each rule of `expect`, in the format's order.
[[nodiscard]] std::vector<Expectation> judge(const Description& description, const DescribedExpect& expect,
                                             const DescribedSummary& summary);

}  // namespace hyrax
