// One contract for every study. A study is a folder here and a line in studies.cpp.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "sim/core/core.h"
#include "sim/result/result.h"
#include "sim/scenario/scenario.h"
#include "sim/study/methods/cost.h"
#include "sim/trace/step_player.h"

namespace hyrax {

/// A scenario and what the user called its file.
struct NamedScenario {
  std::string path = {};
  Scenario scenario = {};
};

/// What the user asked of a study, and what a study may not do itself.
struct StudyRequest {
  Core core;  ///< With the parameters of the scenarios, if they all have the same.
  std::vector<NamedScenario> scenarios = {};          ///< Of different names.
  bool is_quick = false;                              ///< A smaller study, in seconds.
  std::optional<double> within_px = {};               ///< A tolerance.
  std::shared_ptr<const StepProgram> core_step = {};  ///< Null: the core's step is not complete.
  std::string machine = {};  ///< Name of the processor, for results that depend on it.
  CostMeter measure_costs = {};
  bool is_costs_only = false;  ///< Nothing but calls of measure_costs is wanted; the result is not used.
  /// Called from time to time with what is counted ("steps"), how many are done, and of how many.
  std::function<void(const std::string& unit, std::int64_t done, std::int64_t total)> report_progress = {};
};

/// The request does not suit the study: a line for each fault, beginning with its place.
struct RequestRefused : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Study {
  std::string name = {};     ///< On the command line: "frame-rate".
  std::string summary = {};  ///< In a few words, for the help.
  bool takes_within = false;
  bool needs_paper_step = true;
  std::string default_scenarios = {};  ///< Folder to take if none are given; empty: runs without.
  /// ERRORS: RequestRefused.
  Result (*run)(const StudyRequest& request) = nullptr;
};

/// All of them, in the order of the help.
[[nodiscard]] const std::vector<Study>& studies();

}  // namespace hyrax
