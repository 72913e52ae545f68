// What of the model and of the scene a scenario needs: every part left out in turn, then all that are not
// needed at once.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim/study/methods/cost.h"
#include "sim/study/methods/script.h"
#include "sim/study/speed_error/speed_error.h"

namespace hyrax {

enum class Need {
  needed,          ///< Some row moves by more than the tolerance.
  needed_jointly,  ///< Alone it would not be; with all else that is not needed left out as well, it is.
  below,           ///< Rows change, none by more than the tolerance.
  not_exercised,   ///< Not one bit of any row changes.
};

/// The run with a part left out against the whole run, row by row.
struct PathDifference {
  bool is_same_bits = true;
  double path_px = 0.0;  ///< Largest distance; infinite where one run leaves the numbers.
  double end_px = 0.0;   ///< Distance of the last rows: the shift of the resting place, of a run that rests.
  std::int64_t first_step = -1;     ///< The first row that differs; -1: none.
  std::int64_t contacts_moved = 0;  ///< Contacts that moved, appeared or vanished.
};

struct PartNeed {
  std::string part;                ///< One of kPartNames, "jitter", or the name of an input.
  std::optional<Part> model_part;  ///< None: jitter or an input.
  PathDifference difference;
  Need need = Need::needed;
  double saved_ns_per_step = 0.0;  ///< Of the whole run's median; may be negative, by chance.
};

struct SceneNeeds {
  std::string scenario;
  std::int64_t steps = 0;
  bool is_cut = false;  ///< Only the first kScriptFramesMax frames were played.
  bool comes_to_rest =
      false;             ///< No contact byte but the ground's, and less than 0.5 px, in the last second.
  double step_ns = 0.0;  ///< Of the variant kernel with all parts.
  std::vector<PartNeed> parts;
  PathDifference without_all_unneeded;  ///< All that is `below` or `not_exercised`, at once.
  /// Where the study contradicts the replay, one sentence each without its full stop; see contradictions_of.
  std::vector<std::string> broken;
  /// The cheapest method and rate within the tolerance of the fixed laws; where it was asked for and can be.
  std::optional<SpeedError> methods;
  std::string why_no_methods;
};

struct NeedsOptions {
  double within_px = 1.0;
  CostOptions cost;
  std::vector<double> rates_hz;  ///< For the cheapest method; empty: not asked for.
};

/// Plays the scenario with every part left out in turn, and times it.
[[nodiscard]] SceneNeeds study_needs(const Scenario& scenario, const NeedsOptions& options,
                                     const NanosecondClock& now_ns);

/// What the study has of a scenario against the replay, which knows nothing of parts:
/// 1. with all parts the script is the replay's run, bit for bit;
/// 2. a wall is exercised where the replay met it, and nowhere else;
/// 3. friction and the rest rule are exercised only where it met the ground, restitution where it met any
/// wall.
[[nodiscard]] std::vector<std::string> contradictions_of(const Scenario& scenario,
                                                         const std::vector<PartNeed>& parts);

/// The difference that leaving these out makes.
[[nodiscard]] PathDifference difference_without(const Script& script, const Omitted& omitted,
                                                const Parts& parts);

[[nodiscard]] Need need_of(const PathDifference& difference, double within_px);

}  // namespace hyrax
