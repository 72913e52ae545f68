// The command study: asks a study, writes what it found, and prints its verdict.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/core/core.h"
#include "sim/result/result.h"
#include "tools/app/command_line/options.h"

namespace hyrax {

/// What the user asked of a study.
struct StudyInput {
  const Core& core;
  std::vector<std::string> scenarios = {};  ///< Paths.
  bool is_quick = false;
  std::optional<double> within_px = {};
  /// Called from time to time with what is counted ("steps"), how many are done, and of how many.
  std::function<void(const std::string& unit, std::int64_t done, std::int64_t total)> report_progress = {};
  /// The words after the program's name that ask for the same; with `kCostsOption N`, print_costs of N.
  std::vector<std::string> words = {};
};
inline constexpr const char* kCostsOption = "--costs-of-process";

/// A study that a program has.
struct OfferedStudy {
  std::string name = {};
  std::string summary = {};
  bool takes_within = false;
  std::string default_scenarios = {};  ///< Folder to take if none are given; empty: runs without.
  /// ERRORS: Failure.
  std::function<Result(const StudyInput& input)> run = {};
  std::function<void(const Core& core)> require = nullptr;  ///< Refuses cores that it cannot measure.
  /// Measures the study's costs in this process, one of several, and prints them for the one that started it.
  std::function<void(const StudyInput& input, int process)> print_costs = {};
};

/// @param instead names of studies that the program has not, and what is said of each.
[[nodiscard]] Command study_command_of(std::vector<OfferedStudy> studies,
                                       std::vector<std::pair<std::string, std::string>> instead);

}  // namespace hyrax
