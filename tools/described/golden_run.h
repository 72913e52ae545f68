// Golden files of a core that describes itself: a run as it is kept, and a run against the one that is kept.
#pragma once

#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "sim/described/described_comparison.h"
#include "tools/described/trajectory_file.h"
#include "tools/files/golden_place.h"

namespace hyrax {

/// A run, with all that a golden file has of it.
struct GoldenContents {
  DescribedSummary summary = {};
  DescribedRows rows = {};                  ///< Every row of a short run,
  std::vector<DescribedBlock> blocks = {};  ///< the blocks of another.
  std::vector<KeptRow> at_seconds = {};     ///< The last row up to each of the first ten seconds.
  std::vector<DescribedContact> contacts = {};

  [[nodiscard]] std::string state_hash() const { return hex(summary.state_hash); }
  [[nodiscard]] std::int64_t contacts_total() const {
    return std::accumulate(summary.contacts.begin(), summary.contacts.end(), std::int64_t{0});
  }
};

/// Plays the scenario for it. @param also further sinks.
[[nodiscard]] GoldenContents play_for_golden(const DescribedCore& core, const DescribedScenario& scenario,
                                             const std::vector<DescribedSink*>& also = {});

/// What of a scenario changed, by JSON Pointer; empty if both play the same.
[[nodiscard]] std::string scenario_changes(const Description& description, const DescribedScenario& from,
                                           const DescribedScenario& to);

/// All rows of the run of a file: those that it holds, or played again by this core, or in a golden folder by
/// the step of the accepted core. Nothing where neither gives them, or they are too many. REQUIRES: the file
/// stays open.
[[nodiscard]] std::optional<ComparedSide> all_rows_of(const DescribedCore& core, const DescribedFile& file);

struct GoldenComparison : DescribedComparison {
  bool is_proved = false;  ///< By the checksums of the summary alone.
  /// Of a scenario whose own text changed: blessing it accepts no class.
  bool has_other_scenario = false;
  std::string fault = {};  ///< Why the file is not as it was blessed, a sentence; then it never agrees.
};

/// By the checksums of the summary. REQUIRES: the golden file exists.
[[nodiscard]] bool is_proved_to_agree(const DescribedCore& core, const DescribedScenario& scenario,
                                      const GoldenContents& run, const GoldenPlace& place);

/// REQUIRES: the golden file exists; as read_isolated.
/// ERRORS: as DescribedFile's.
[[nodiscard]] GoldenComparison compare_with_golden(const DescribedCore& core,
                                                   const DescribedScenario& scenario,
                                                   const GoldenContents& run, const GoldenPlace& place);

/// Whether the file is a trajectory file as bless writes it, of any description of this core.
[[nodiscard]] bool is_golden_h5(const DescribedCore& core, const std::string& path);

/// Writes the pair: the summary, then the rows.
/// ERRORS: Failure(cannot_access).
void write_golden_pair(const DescribedCore& core, const DescribedScenario& scenario, const GoldenPlace& place,
                       const std::string& reason);

}  // namespace hyrax
