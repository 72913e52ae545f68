// Which scenarios did not agree when `check` last saw them.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "tools/app/check/check_verdict.h"
#include "tools/store/output_guard.h"

namespace hyrax {

/// A file for each folder in which `check` is run, in $XDG_CACHE_HOME/hyrax-sim or ~/.cache/hyrax-sim.
/// Without these folders, or where they cannot be read or written, nothing is recorded.
class LastFailed {
 public:
  /// Reads what was recorded in the current folder.
  LastFailed();

  /// Whether the scenario, or golden file without one, did not agree.
  [[nodiscard]] bool contains(const std::string& path) const;
  /// Records the new verdicts; those of a folder that were not asked for this time are kept. Writes no file
  /// in a golden folder.
  void update(const std::vector<CheckVerdict>& verdicts, OutputGuard& guard);

 private:
  std::string file_;             // Empty: nothing is recorded.
  std::set<std::string> paths_;  // Absolute.
};

}  // namespace hyrax
