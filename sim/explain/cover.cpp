#include "sim/explain/cover.h"

#include <algorithm>
#include <numeric>

#include "sim/explain/step_replay.h"

namespace hyrax {

Cover::Cover(const std::vector<Candidate>& candidates, const std::vector<StepCase>& cases,
             const Constants& program)
    : candidates_(candidates),
      cases_(cases),
      program_(program),
      trials_(candidates.size() * cases.size()),
      rest_(cases.size()) {
  std::iota(rest_.begin(), rest_.end(), std::size_t{0});
  for (std::size_t candidate = 0; candidate < candidates_.size(); ++candidate)
    for (std::size_t at = 0; at < cases_.size(); ++at) {
      const bool fits = std::ranges::all_of(cases_[at].evidence, [&](const ObservedStep& step) {
        return gives(candidates_[candidate].step_for(cases_[at].is_dt_fixed), step);
      });
      trial(candidate, at) = fits ? Trial::fits : Trial::fails;
    }
}

bool Cover::is_eligible(std::size_t candidate) {
  if (candidates_[candidate].rank <= TieRank::all_constants_of_program) return true;
  return std::ranges::any_of(rest_, [&](std::size_t at) {
    return !cases_[at].has_equal_rows && trial(candidate, at) != Trial::fails;
  });
}

std::size_t Cover::fitting(std::size_t candidate) {
  return static_cast<std::size_t>(
      std::ranges::count_if(rest_, [&](std::size_t at) { return trial(candidate, at) != Trial::fails; }));
}

std::size_t Cover::reproduced(std::size_t candidate) {
  for (const std::size_t at : rest_)
    if (trial(candidate, at) == Trial::fits) {
      const StepCase& one = cases_[at];
      const bool is_run =
          reproduces(candidates_[candidate].step_for(one.is_dt_fixed), program_, one.playback, one.fresh);
      trial(candidate, at) = is_run ? Trial::reproduces : Trial::fails;
    }
  return fitting(candidate);
}

// Candidates are in order of their ranks. One that fits fewer cases than another reproduces is not replayed.
std::optional<Cover::Choice> Cover::best() {
  std::vector<std::size_t> order(candidates_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::ranges::greater(),
                           [this](std::size_t candidate) { return fitting(candidate); });
  std::optional<Choice> best;
  for (const std::size_t candidate : order) {
    const std::size_t most = fitting(candidate);
    if (most == 0 || (best && most < best->count)) break;
    if ((best && most == best->count && candidate > best->candidate) || !is_eligible(candidate)) continue;
    const std::size_t count = reproduced(candidate);
    if (count > 0 && is_eligible(candidate) &&
        (!best || count > best->count || (count == best->count && candidate < best->candidate)))
      best = {candidate, count};
  }
  return best;
}

std::vector<CauseGroup> Cover::groups() {
  std::vector<CauseGroup> groups;
  while (const std::optional<Choice> choice = best()) {
    CauseGroup& group = groups.emplace_back(CauseGroup{candidates_[choice->candidate].cause, {}});
    std::erase_if(rest_, [&](std::size_t at) {
      if (trial(choice->candidate, at) != Trial::reproduces) return false;
      group.runs.push_back(cases_[at].run);
      return true;
    });
  }
  return groups;
}

}  // namespace hyrax
