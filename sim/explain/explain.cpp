#include "sim/explain/explain.h"

#include <algorithm>
#include <iterator>

#include "sim/explain/candidate.h"
#include "sim/explain/cover.h"
#include "sim/explain/diagnosis.h"
#include "sim/explain/fitted_constant.h"
#include "sim/explain/step_replay.h"
#include "sim/scenario/frame_clock.h"

namespace hyrax {
namespace {

// In order of their ranks.
std::vector<Candidate> candidates_for(const Constants& golden, const Constants& program) {
  std::vector<Candidate> candidates = constant_candidates(golden, program);
  std::ranges::move(statement_candidates(golden), std::back_inserter(candidates));
  std::ranges::move(order_candidates(golden), std::back_inserter(candidates));
  std::ranges::stable_sort(candidates, {}, &Candidate::rank);
  return candidates;
}

// They come last of all ranks, so they are made only where others leave something to explain.
std::vector<Candidate> fitted_for(const Constants& golden, const std::vector<StepCase>& cases) {
  std::vector<const std::vector<ObservedStep>*> evidence;
  for (const StepCase& one : cases)
    if (!one.has_equal_rows) evidence.push_back(&one.evidence);
  return fitted_candidates(golden, evidence);
}

std::size_t explained_runs(const std::vector<CauseGroup>& groups) {
  std::size_t runs = 0;
  for (const CauseGroup& group : groups) runs += group.runs.size();
  return runs;
}

// Frame times and inputs are one cause each, whatever differs first in a run.
bool is_same_cause(const Cause& a, const Cause& b) {
  const bool has_own_detail = a.operation != kClockCause && a.operation != kInputCause;
  return a.operation == b.operation && a.kind == b.kind && (!has_own_detail || a.detail == b.detail);
}

class Explanation {
 public:
  Explanation(const std::vector<DifferingRun>& runs, const Kernel& program)
      : runs_(runs), program_(program) {}

  std::vector<CauseGroup> groups() {
    std::vector<std::size_t> open;
    for (std::size_t run = 0; run < runs_.size(); ++run) {
      diagnoses_.push_back(diagnose(runs_[run], program_));
      if (diagnoses_[run].cause)
        add({*diagnoses_[run].cause, {run}});
      else
        open.push_back(run);
    }
    while (!open.empty()) cover_alike(open);
    for (CauseGroup& group : groups_) std::ranges::sort(group.runs);
    std::ranges::stable_sort(groups_, [](const CauseGroup& a, const CauseGroup& b) {
      const bool is_known_a = a.cause.kind != CauseKind::unknown;
      const bool is_known_b = b.cause.kind != CauseKind::unknown;
      return is_known_a != is_known_b ? is_known_a : a.runs.size() > b.runs.size();
    });
    return std::move(groups_);
  }

 private:
  void add(const CauseGroup& found) {
    const auto group = std::ranges::find_if(
        groups_, [&](const CauseGroup& one) { return is_same_cause(one.cause, found.cause); });
    if (group == groups_.end())
      groups_.push_back(found);
    else
      group->runs.insert(group->runs.end(), found.runs.begin(), found.runs.end());
  }

  // Takes from `open` the runs whose golden files have the constants of the first one's.
  void cover_alike(std::vector<std::size_t>& open) {
    const Constants constants = *runs_[open.front()].golden.constants;
    std::vector<StepCase> cases;
    std::erase_if(open, [&](std::size_t run) {
      const DifferingRun& one = runs_[run];
      if (!same_bits(*one.golden.constants, constants)) return false;
      cases.push_back({run, one.fresh, playback_of(one.golden),
                       FrameClock(one.golden.scenario.clock).is_fixed(), diagnoses_[run].has_equal_rows,
                       std::move(diagnoses_[run].evidence)});
      return true;
    });
    std::vector<Candidate> candidates = candidates_for(constants, *program_.constants());
    std::vector<CauseGroup> found = Cover(candidates, cases, *program_.constants()).groups();
    if (explained_runs(found) < cases.size()) {
      std::ranges::move(fitted_for(constants, cases), std::back_inserter(candidates));
      found = Cover(candidates, cases, *program_.constants()).groups();
    }
    std::vector<bool> is_explained(runs_.size());
    for (const CauseGroup& group : found) {
      add(group);
      for (const std::size_t run : group.runs) is_explained[run] = true;
    }
    for (const StepCase& one : cases)
      if (!is_explained[one.run]) add({unexplained(runs_[one.run], one.evidence), {one.run}});
  }

  const std::vector<DifferingRun>& runs_;
  const Kernel& program_;
  std::vector<Diagnosis> diagnoses_;
  std::vector<CauseGroup> groups_;
};

}  // namespace

std::vector<CauseGroup> explain(const std::vector<DifferingRun>& runs, const Kernel& program) {
  return Explanation(runs, program).groups();
}

}  // namespace hyrax
