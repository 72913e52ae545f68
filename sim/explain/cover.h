// The fewest candidates for the most runs: the best one first, then again among the rest.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "sim/explain/candidate.h"
#include "sim/explain/explain.h"
#include "sim/explain/observed_step.h"
#include "sim/scenario/scenario.h"

namespace hyrax {

/// A run for which candidates are tried.
struct StepCase {
  std::size_t run = 0;  ///< Its index in what is explained.
  const StoredRun& fresh;
  Scenario playback;            ///< The golden file's frame times and inputs.
  bool is_dt_fixed = false;     ///< The clock gives one dt.
  bool has_equal_rows = false;  ///< Only what is measured of the contacts differs.
  std::vector<ObservedStep> evidence;
};

/// Tries candidates on cases. Most fail on the first step of the evidence; a replay to the end, which
/// decides, is made only where it can change what is taken.
class Cover {
 public:
  /// Refers to both. @param program the constants of this program's core.
  Cover(const std::vector<Candidate>& candidates, const std::vector<StepCase>& cases,
        const Constants& program);

  /// Groups of cases, by the candidate that reproduces them; those of none are left out.
  [[nodiscard]] std::vector<CauseGroup> groups();

 private:
  enum class Trial : std::uint8_t { fails, fits, reproduces };
  struct Choice {
    std::size_t candidate = 0;
    std::size_t count = 0;
  };

  [[nodiscard]] Trial& trial(std::size_t candidate, std::size_t at) {
    return trials_[candidate * cases_.size() + at];
  }
  // Whether something besides equal rows speaks for it: they fit any candidate that changes nothing there.
  [[nodiscard]] bool is_eligible(std::size_t candidate);
  [[nodiscard]] std::size_t fitting(std::size_t candidate);
  [[nodiscard]] std::size_t reproduced(std::size_t candidate);
  [[nodiscard]] std::optional<Choice> best();

  const std::vector<Candidate>& candidates_;
  const std::vector<StepCase>& cases_;
  Constants program_;
  std::vector<Trial> trials_;
  std::vector<std::size_t> rest_;  // The cases of no group yet.
};

}  // namespace hyrax
