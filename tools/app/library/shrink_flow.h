// `shrink` for any core.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "sim/core/core.h"
#include "tools/app/command_line/options.h"
#include "tools/platform/guarded_child.h"

namespace hyrax {

struct ShrinkLimits {
  double search_s = 60.0;
  double run_s = 10.0;  ///< A run that takes longer does not end.
};

struct ScenarioSize {
  std::int64_t steps = 0;
  std::int64_t events = 0;
};

struct SmallerScenario {
  std::string kept = {};  ///< As "final_x_px is above its range".
  std::string text = {};  ///< Of its file.
  ScenarioSize before = {};
  ScenarioSize after = {};
  std::int64_t trials = 0;
  bool is_complete = false;  ///< Else a limit ended the search.
};

/// ERRORS: Failure(bad_input) "PATH: nothing to keep: ...".
using ShrinkScenario =
    std::function<SmallerScenario(const Core& core, const std::string& path, const ShrinkLimits& limits)>;

/// Of a run that ended its process: "signal 11 (SIGSEGV)", "no end within 10 s".
[[nodiscard]] std::string end_text(const WorkEnd& end, double limit_s);

/// The description of a smaller scenario. @param name, steps of the one that it is made of.
[[nodiscard]] std::string shrunk_from(const std::string& name, std::int64_t steps, const std::string& kept);

/// @param said what `run` may say of a scenario that is made smaller.
[[nodiscard]] Command shrink_command_of(const std::string& said, ShrinkScenario find);

}  // namespace hyrax
