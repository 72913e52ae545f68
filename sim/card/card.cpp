#include "sim/card/card.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <numeric>

#include "sim/card/core_in_use.h"
#include "sim/card/flings.h"
#include "sim/search/random_scenario.h"
#include "sim/search/run_check.h"
#include "sim/study/hard_cases/hard_case.h"
#include "sim/study/paper/paper_claim.h"

namespace hyrax {
namespace {

constexpr std::uint64_t kRandomRuns = 500;

Digest rows_digest(const CoreFunctions& core, const std::vector<NamedScenario>& library) {
  StateHash hash;
  for (const NamedScenario& named : library)
    for (const Row& row : play_by(core, named.scenario).rows) hash.add(row);
  return hash.value();
}

void measure_library(const CoreFunctions& base, const CoreFunctions& candidate, const CardRequest& request,
                     Card& card) {
  for (const NamedScenario& named : request.library) {
    CoreRun from = play_by(base, named.scenario);
    CoreRun to = play_by(candidate, named.scenario);
    RunChange change = compare_runs(named.scenario, from, to);
    card.library.classes.add(change);
    if (change.is_cut) ++card.library.cut;
    card.contacts.contacts.before += change.contacts_before;
    card.contacts.contacts.after += change.contacts_after;
    card.contacts.moved += std::ssize(change.contacts.moved);
    card.contacts.only_before += std::ssize(change.contacts.only_a);
    card.contacts.only_after += std::ssize(change.contacts.only_b);
    if (!change.contacts.is_none()) ++card.contacts.scenarios;
    if (!change.has_same_bits) card.library.changed.push_back({named.path, std::move(change)});
  }
}

RecordingLine recordings_of(const CardRequest& request, const LibraryLine& library) {
  RecordingLine line{.recordings = std::ssize(request.recordings), .moved = {}};
  for (const NamedScenario& recording : request.recordings)
    for (const ScenarioChange& changed : library.changed)
      if (changed.path == recording.path && changed.change.end_shift_px > RestAnchor::kStill_px)
        line.moved.push_back({changed.path, changed.change.end_shift_px});
  return line;
}

// Names of what is broken, in the cases' order.
std::vector<std::string> broken_by(const CoreFunctions& core, const std::vector<HardCase>& cases) {
  const CoreInUse in_use(core);
  std::vector<PlayedCase> played;
  played.reserve(cases.size());
  for (const HardCase& hard_case : cases) played.push_back({hard_case, play_hard_case(hard_case)});
  std::vector<std::string> broken;
  for (const Judgement& judgement : judgements_of(played))
    if (judgement.verdict == CaseVerdict::broken || judgement.verdict == CaseVerdict::expected_failure_gone)
      broken.push_back(judgement.played->hard_case.name + ": " + std::string(judgement.text().name));
  return broken;
}

Share random_runs_broken_by(const CoreFunctions& core, const std::vector<RandomRun>& runs) {
  const CoreInUse in_use(core);
  Share share{.count = 0, .of = std::ssize(runs)};
  for (const RandomRun& run : runs)
    if (first_broken(run.scenario, check_run(run.scenario, run.stops).measures)) ++share.count;
  return share;
}

std::vector<RandomRun> random_runs(std::uint64_t seed) {
  std::vector<RandomRun> runs;
  for (std::uint64_t run = 0; run < kRandomRuns; ++run) runs.push_back(random_run(seed, run));
  return runs;
}

std::vector<std::string> missing_in(const std::vector<std::string>& names,
                                    const std::vector<std::string>& others) {
  std::vector<std::string> missing;
  std::copy_if(names.begin(), names.end(), std::back_inserter(missing), [&others](const std::string& name) {
    return std::find(others.begin(), others.end(), name) == others.end();
  });
  return missing;
}

HardCaseLine measure_hard_cases(const CoreFunctions& base, const CoreFunctions& candidate,
                                const CardRequest& request) {
  std::vector<HardCase> cases;
  for (const NamedScenario& named : request.hard)
    for (HardCase& hard_case : hard_cases_of(named.scenario))
      if (!hard_case.is_long) cases.push_back(std::move(hard_case));
  const std::vector<std::string> before = broken_by(base, cases);
  const std::vector<std::string> after = broken_by(candidate, cases);
  const std::vector<RandomRun> runs = random_runs(request.seed);
  return {.cases = std::ssize(cases),
          .broken = {std::ssize(before), std::ssize(after)},
          .newly_broken = missing_in(after, before),
          .mended = missing_in(before, after),
          .random_runs = {random_runs_broken_by(base, runs), random_runs_broken_by(candidate, runs)}};
}

struct Claims {
  std::vector<Claim> all;
  std::vector<Claim> timings;
};

Claims claims_by(const CoreFunctions& core, double step_s) {
  const CoreInUse in_use(core);
  return {paper_claims(step_s), speed_claims(step_s)};
}

ClaimLine measure_claims(const CoreFunctions& base, const CoreFunctions& candidate, const CostLine& cost) {
  constexpr double kNanosecond_s = 1e-9;
  const auto [before, timings] = claims_by(base, cost.step_ns.before.median * kNanosecond_s);
  const auto after = claims_by(candidate, cost.step_ns.after.median * kNanosecond_s).all;
  const auto is_timing = [&timings = timings](const Claim& claim) {
    return std::any_of(timings.begin(), timings.end(),
                       [&claim](const Claim& timing) { return timing.id == claim.id; });
  };
  assert(before.size() == after.size());
  ClaimLine line{.claims = std::ssize(before), .changed = {}};
  for (std::size_t index = 0; index < before.size(); ++index) {
    const Claim& from = before[index];
    const Claim& to = after[index];
    if (from.verdict != to.verdict)
      line.changed.push_back({from.id,
                              {std::string(name_of(from.verdict)), std::string(name_of(to.verdict))},
                              {from.number, to.number},
                              from.unit});
    else if (!is_timing(from) && !same_bits(from.number, to.number))
      ++line.other_numbers;
  }
  return line;
}

}  // namespace

void ClassCounts::add(const RunChange& change) {
  if (change.difference)
    ++of_class[static_cast<std::size_t>(*change.difference)];
  else
    ++same_bits;
}

std::int64_t ClassCounts::total() const {
  return std::accumulate(of_class.begin(), of_class.end(), same_bits);
}

Card measure_card(const CoreFunctions& base, const CoreFunctions& candidate, const CardRequest& request) {
  const CoreInUse in_use(
      base);  // Random runs and hard cases depend on a core: both cores play those of the base.
  Card card{.seed = request.seed,
            .flings = request.flings,
            .scenarios = std::ssize(request.library),
            .cost = measure_cost(base, candidate, request.seed, request.now_ns)};
  const Digest first = rows_digest(candidate, request.library);
  measure_library(base, candidate, request, card);
  FlingLines flings = measure_flings(base, candidate, request.seed, request.flings);
  card.random = flings.random;
  card.energy = flings.energy;
  card.exact = std::move(flings.exact);
  card.displays = measure_displays(base, candidate, request.seed, request.flings);
  if (!request.hard.empty()) card.hard_cases = measure_hard_cases(base, candidate, request);
  card.claims = measure_claims(base, candidate, card.cost);
  if (!request.recordings.empty()) card.recordings = recordings_of(request, card.library);
  // Some state shows only after many calls.
  if (rows_digest(candidate, request.library) != first)
    throw CoreRefused("does not repeat: the scenarios played again give other rows");
  return card;
}

}  // namespace hyrax
