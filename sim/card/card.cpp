#include "sim/card/card.h"

#include <algorithm>
#include <bitset>
#include <cassert>
#include <functional>
#include <numeric>

#include "sim/search/random_scenario.h"
#include "sim/search/run_check.h"
#include "sim/study/hard_cases/hard_case.h"
#include "sim/study/paper/paper_claim.h"

namespace hyrax {
namespace {

constexpr std::uint64_t kRandomRuns = 500;

std::string place_of(const NamedScenario& named) { return "scenario " + named.path; }

}  // namespace

std::string rows_hash(const ComparedCore& core, const CardRequest& request) {
  StateHash hash;
  for (const NamedScenario& named : request.library)
    hash.add(play_by(core.at(place_of(named)), named.scenario).hash);
  return hex(hash.value());
}

namespace {

void measure_library(const ComparedCore& base, const ComparedCore& candidate, const CardRequest& request,
                     Card& card) {
  for (const NamedScenario& named : request.library) {
    const std::string place = place_of(named);
    CoreRun from = play_by(base.at(place), named.scenario);
    CoreRun to = play_by(candidate.at(place), named.scenario);
    RunChange change = compare_runs(named.scenario, from, to);
    change.no_longer_settles =
        !settles(candidate.at(place), named.scenario, to) && settles(base.at(place), named.scenario, from);
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

using InvariantSet = std::bitset<kInvariantCount>;

// A hard case or a random run, as one core plays it. Where a core lacks constants, nothing is judged.
struct HeldRun {
  std::string name;
  Digest hash{};              // CoreRun::hash.
  InvariantSet held = {};     // Where they were checked.
  InvariantSet failing = {};  // Do not hold,
  InvariantSet broken = {};   // and are not expected to fail.

  void add(const InvariantMeasures& measures, const auto& is_expected_to_fail) {
    for (std::size_t index = 0; index < kInvariantCount; ++index) {
      held[index] = measures[index].is_checked && measures[index].holds;
      failing[index] = !measures[index].holds;
      broken[index] = failing[index] && !is_expected_to_fail(static_cast<Invariant>(index));
    }
  }
};

void judge_into(const Core& core, const HardCase& hard_case, HeldRun& run) {
  const HardCaseResult result = play_hard_case(core, hard_case);
  run.add(result.measures, [&](Invariant invariant) {
    return judge(hard_case, result, invariant) == CaseVerdict::expected_failure;
  });
}

void judge_into(const Core& core, const RandomRun& random, HeldRun& run) {
  run.add(check_run(core, random.scenario, random.stops).measures,
          [&](Invariant invariant) { return is_broken_by_listing(invariant, random.scenario); });
}

const std::string& name_of(const HardCase& hard_case) { return hard_case.name; }
const std::string& name_of(const RandomRun& random) { return random.scenario.name; }

// @param kind of the runs, for messages.
template <class Played>
std::vector<HeldRun> held_runs_of(const ComparedCore& compared, const std::string& kind,
                                  const std::vector<Played>& all, bool is_judged) {
  std::vector<HeldRun> runs;
  for (const Played& played : all) {
    const Core& core = compared.at(kind + " " + name_of(played));
    HeldRun& run =
        runs.emplace_back(HeldRun{.name = name_of(played), .hash = play_by(core, played.scenario).hash});
    if (is_judged) judge_into(core, played, run);
  }
  return runs;
}

using HeldRuns = BeforeAfter<std::vector<HeldRun>>;

std::int64_t other_bits(const HeldRuns& runs) {
  return std::inner_product(runs.before.begin(), runs.before.end(), runs.after.begin(), std::int64_t{0},
                            std::plus(),
                            [](const HeldRun& a, const HeldRun& b) { return a.hash != b.hash ? 1 : 0; });
}

InvariantLine invariant_line(bool is_general, const HeldRuns& cases, const HeldRuns& random) {
  InvariantSet kind;
  for (std::size_t index = 0; index < kInvariantCount; ++index)
    kind[index] = kInvariantTexts[index].is_general == is_general;
  const auto breaking = [&kind](const std::vector<HeldRun>& runs) {
    return std::count_if(runs.begin(), runs.end(),
                         [&kind](const HeldRun& run) { return (run.broken & kind).any(); });
  };
  InvariantLine line{.cases = {breaking(cases.before), breaking(cases.after)},
                     .random_runs = {{breaking(random.before), std::ssize(random.before)},
                                     {breaking(random.after), std::ssize(random.after)}},
                     .newly_broken = {},
                     .mended = {}};
  for (const HeldRuns* const runs : {&cases, &random})
    for (std::size_t run = 0; run < runs->before.size(); ++run) {
      const HeldRun& from = runs->before[run];
      const HeldRun& to = runs->after[run];
      for (std::size_t index = 0; index < kInvariantCount; ++index) {
        if (!kind[index]) continue;
        const std::string name = from.name + ": " + std::string(kInvariantTexts[index].name);
        if (to.broken[index] && !from.broken[index]) line.newly_broken.push_back(name);
        if (from.failing[index] && to.held[index]) line.mended.push_back(name);
      }
    }
  return line;
}

HardCaseLine measure_hard_cases(const ComparedCore& base, const ComparedCore& candidate,
                                const CardRequest& request, bool is_judged) {
  // Both cores play those that are made by the constants of the base.
  const Core& core = base.at("the hard cases");
  std::vector<HardCase> cases;
  for (const NamedScenario& named : request.hard)
    for (HardCase& hard_case : hard_cases_of(core, named.scenario))
      if (!hard_case.is_long) cases.push_back(std::move(hard_case));
  std::vector<RandomRun> runs;
  for (std::uint64_t run = 0; run < kRandomRuns; ++run) runs.push_back(random_run(core, request.seed, run));
  const HeldRuns held{held_runs_of(base, "hard case", cases, is_judged),
                      held_runs_of(candidate, "hard case", cases, is_judged)};
  const HeldRuns random{held_runs_of(base, "random run", runs, is_judged),
                        held_runs_of(candidate, "random run", runs, is_judged)};
  return {.cases = std::ssize(cases),
          .other_cases = other_bits(held),
          .other_random_runs = {other_bits(random), std::ssize(runs)},
          .general = invariant_line(true, held, random),
          .listing = invariant_line(false, held, random)};
}

ClaimLine measure_claims(const ComparedCore& base, const ComparedCore& candidate, const CostLine& cost) {
  constexpr double kNanosecond_s = 1e-9;
  const auto claims_by = [](const ComparedCore& core, const Band& step_ns) {
    return paper_claims(core.at("the paper's claims"), step_ns.median * kNanosecond_s);
  };
  const std::vector<Claim> before = claims_by(base, cost.step_ns.before);
  const std::vector<Claim> after = claims_by(candidate, cost.step_ns.after);
  assert(before.size() == after.size());
  ClaimLine line{.claims = std::ssize(before), .changed = {}, .not_measured = {}};
  for (std::size_t index = 0; index < before.size(); ++index) {
    const Claim& from = before[index];
    const Claim& to = after[index];
    const auto is_measured = [](const Claim& claim) { return claim.verdict != ClaimVerdict::not_measured; };
    if (is_measured(from) != is_measured(to))
      line.not_measured.push_back(from.id);
    else if (from.verdict != to.verdict)
      line.changed.push_back({from.id,
                              {std::string(name_of(from.verdict)), std::string(name_of(to.verdict))},
                              {from.number, to.number},
                              from.unit});
    else if (!from.is_timing && !same_bits(from.number, to.number))
      ++line.other_numbers;
  }
  return line;
}

std::string lacking_text(const ComparedCore& base, const ComparedCore& candidate) {
  std::string text;
  for (const auto& [core, name] : {std::pair(&base, "the base"), {&candidate, "the candidate"}})
    if (!core->lacking.empty())
      text += (text.empty() ? "" : "; ") + std::string(name) + " has no " + core->lacking;
  return text;
}

StepLine step_line(const CardRequest& request, bool has_other_bits) {
  const StepProof& proof = request.proof;
  StepLine line{.why = proof.why, .changes = request.changes};
  if (proof.is_equal && has_other_bits) {
    line.why = "the traced steps are equal, but the compiled cores give other bits";
  } else if (has_other_bits) {
    line.status = StepStatus::changed;
    if (proof.is_complete) line.why.clear();
  } else if (proof.is_equal) {
    line.status = StepStatus::proved_equal;
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

Card measure_card(const ComparedCore& base, const ComparedCore& candidate, const CardRequest& request) {
  Card card{.seed = request.seed,
            .flings = request.flings,
            .scenarios = std::ssize(request.library),
            .lacking = lacking_text(base, candidate),
            .cost = measure_cost(base, candidate, request.seed, request.now_ns)};
  measure_library(base, candidate, request, card);
  measure_flings(base, candidate, card);
  card.displays = measure_displays(base, candidate, request.seed, request.flings);
  card.rest = measure_rest(base, candidate);
  card.hard_cases = measure_hard_cases(base, candidate, request, card.lacking.empty());
  if (card.lacking.empty()) card.claims = measure_claims(base, candidate, card.cost);
  card.step = step_line(request, card.has_other_bits());
  if (!request.recordings.empty()) card.recordings = recordings_of(request, card.library);
  // Some state shows only after many calls.
  for (const auto& [core, hash] :
       {std::pair(&base, &request.rows_hash.before), {&candidate, &request.rows_hash.after}})
    if (rows_hash(*core, request) != *hash)
      throw CoreRefused(core->number, "does not repeat: scenarios played again by another process differ");
  return card;
}

}  // namespace hyrax
