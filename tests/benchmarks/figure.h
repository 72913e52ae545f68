// A figure of speed: what was measured, against what it should reach.
#pragma once

#include <string>
#include <vector>

#include "tests/benchmarks/stopwatch.h"

namespace hyrax::bench {

struct Figure {
  std::string what;
  double measured = 0.0;
  double low = 0.0;  ///< First and third quartile of the measured value.
  double high = 0.0;
  double goal = 0.0;
  bool is_at_least = true;  ///< The goal is a floor; else a ceiling.
  std::string unit;
};

enum class Goal { at_least, at_most };

/// One time as a multiple of another, times `scale`.
[[nodiscard]] inline Figure ratio(std::string what, const Timing& above, const Timing& below, Goal kind,
                                  double goal, double scale = 1.0) {
  return {std::move(what),
          scale * above.median() / below.median(),
          scale * above.quantile(0.25) / below.quantile(0.75),
          scale * above.quantile(0.75) / below.quantile(0.25),
          goal,
          kind == Goal::at_least,
          ""};
}

/// Stepping, replay, hash and rows, in this process.
[[nodiscard]] std::vector<Figure> core_figures();
/// A core that describes itself, in this process.
[[nodiscard]] std::vector<Figure> described_figures();
/// Measuring against the reference, in this process.
[[nodiscard]] std::vector<Figure> drift_figures();
/// Many members of a sweep at once, in this process, on one thread.
[[nodiscard]] std::vector<Figure> ensemble_figures();
/// The program as users start it. @param program path of hyrax-sim; @param scenarios folder.
[[nodiscard]] std::vector<Figure> program_figures(const std::string& program, const std::string& scenarios);

}  // namespace hyrax::bench
