#include "sim/compare/expectations.h"

#include <charconv>
#include <cmath>
#include <limits>

namespace hyrax {
namespace {

std::string text_of(const Interval& interval) {
  if (interval.low == interval.high) return shortest_text(interval.high);
  if (std::isinf(interval.low)) return "at most " + shortest_text(interval.high);
  return shortest_text(interval.low) + " .. " + shortest_text(interval.high);
}

}  // namespace

std::string shortest_text(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

void Judge::is(const char* rule, const std::optional<bool>& wanted, bool measured) {
  if (wanted) verdicts_.push_back({rule, *wanted ? "true" : "false", *wanted == measured, measured});
}

void Judge::within(const std::string& rule, const std::optional<Interval>& wanted,
                   const std::optional<double>& measured) {
  if (!wanted) return;
  Expectation verdict{rule, text_of(*wanted), false, {}, wanted};
  if (measured) {
    verdict.holds = *measured >= wanted->low && *measured <= wanted->high;
    verdict.measured = *measured;
  }
  verdicts_.push_back(std::move(verdict));
}

void Judge::at_most(const char* rule, const std::optional<double>& wanted,
                    const std::optional<double>& measured) {
  if (wanted) within(rule, Interval{-std::numeric_limits<double>::infinity(), *wanted}, measured);
}

void Judge::equals(const char* rule, const std::optional<std::string>& wanted, const std::string& measured) {
  if (wanted) verdicts_.push_back({rule, *wanted, *wanted == measured, measured});
}

std::vector<Expectation> judge(const Expect& expect, const RunSummary& summary,
                               const std::optional<RunErrors>& errors) {
  Judge judge;
  judge.is("in_bounds", expect.in_bounds, !summary.out_of_bounds_step);
  judge.is("finite", expect.finite, !summary.non_finite_step);
  judge.within("final_x_px", expect.final_x_px, summary.final.x_px);
  judge.within("final_y_px", expect.final_y_px, summary.final.y_px);
  judge.within("at_rest_since_s", expect.at_rest_since_s, summary.at_rest_since_s);
  for (const Wall wall : kWalls)
    judge.within("contacts/" + std::string(name_of(wall)), expect.contacts[wall],
                 static_cast<double>(summary.contacts[wall]));
  judge.equals("state_hash", expect.state_hash, hex(summary.state_hash));
  if (errors) {
    judge.at_most("implementation_px_max", expect.implementation_px_max, errors->implementation_px);
    judge.at_most("truncation_px_max", expect.truncation_px_max, errors->truncation_px);
    judge.at_most("energy_drift_rel_max", expect.energy_drift_rel_max, errors->energy_drift_rel);
  }
  return judge.take();
}

bool bounds_errors(const Expect& expect) {
  return expect.implementation_px_max || expect.truncation_px_max || expect.energy_drift_rel_max;
}

}  // namespace hyrax
