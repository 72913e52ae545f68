// What a scenario's author means to hold, against what the run came to.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "sim/scenario/scenario.h"
#include "sim/trajectory/run_summary.h"

namespace hyrax {

/// The three errors of a run that `expect` may bound; see sim/reference. What no arc of the run has,
/// is none, and keeps no bound.
struct RunErrors {
  std::optional<double> implementation_px;
  std::optional<double> truncation_px;
  std::optional<double> energy_drift_rel;
};

struct Expectation {
  std::string rule;    ///< The key in `expect`, as "contacts/left".
  std::string wanted;  ///< "true", "1069 .. 1070", "at most 3".
  bool holds = false;
  std::variant<std::monostate, bool, double, std::string> measured;  ///< Nothing where there is none.
  std::optional<Interval> range = {};  ///< In which it must be, if it must be in one.
};

/// Collects verdicts on rules, of each that is set.
class Judge {
 public:
  void is(const char* rule, const std::optional<bool>& wanted, bool measured);
  /// What was not measured, as the moment of rest of a run that does not rest, is never within.
  void within(const std::string& rule, const std::optional<Interval>& wanted,
              const std::optional<double>& measured);
  void at_most(const char* rule, const std::optional<double>& wanted, const std::optional<double>& measured);
  void equals(const char* rule, const std::optional<std::string>& wanted, const std::string& measured);
  void add(Expectation verdict) { verdicts_.push_back(std::move(verdict)); }
  [[nodiscard]] std::vector<Expectation> take() { return std::move(verdicts_); }

 private:
  std::vector<Expectation> verdicts_;
};

/// Shortest-round-trip, in any locale.
[[nodiscard]] std::string shortest_text(double value);

/// A verdict for each rule that is set, in the format's order.
/// REQUIRES: the summary looked for bounds if in_bounds is set; `errors` where an error is bounded.
[[nodiscard]] std::vector<Expectation> judge(const Expect& expect, const RunSummary& summary,
                                             const std::optional<RunErrors>& errors = {});

/// Whether `expect` bounds an error against the reference.
[[nodiscard]] bool bounds_errors(const Expect& expect);

}  // namespace hyrax
