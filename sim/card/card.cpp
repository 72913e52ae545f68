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

bool is_recording(const std::string& path) { return path.starts_with("recorded/"); }

CoreRun run_of(const NamedScenario& named, const ComparedCore& core) {
  return play_by(core.at("scenario " + named.path), named.scenario);
}

void measure_library(const ComparedCores& cores, const CardRequest& request, Card& card) {
  for (const NamedScenario& named : request.library) {
    if (is_recording(named.path)) ++card.recordings;
    auto [from, to] = of_both(cores, [&](const ComparedCore& core) { return run_of(named, core); });
    RunChange change = compare_runs(named.scenario, from, to);
    const auto settles_by = [&named](const ComparedCore& core, const CoreRun& run) {
      return settles(core.at("scenario " + named.path), named.scenario, run);
    };
    change.no_longer_settles = !settles_by(cores.after, to) && settles_by(cores.before, from);
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

using InvariantSet = std::bitset<kInvariantCount>;

// A hard case or a random run, as one core plays it. Where a core lacks constants, nothing is judged.
struct HeldRun {
  std::string name;
  Digest hash{};              // CoreRun::hash.
  InvariantSet held = {};     // Where they were checked.
  InvariantSet failing = {};  // Do not hold,
  InvariantSet broken = {};   // and are not expected to fail.
};

HeldRun held_run_of(const Core& core, const HardCase& hard_case, bool is_judged) {
  HeldRun run{.name = hard_case.name, .hash = play_by(core, hard_case.scenario).hash};
  if (!is_judged) return run;
  const PlayedCase played = play_hard_case(core, hard_case);
  for (std::size_t index = 0; index < kInvariantCount; ++index) {
    run.held[index] = played.measures[index].is_checked && played.measures[index].holds;
    run.failing[index] = !played.measures[index].holds;
    run.broken[index] = judge(played, static_cast<Invariant>(index)) == CaseVerdict::broken;
  }
  return run;
}

using HeldRuns = BeforeAfter<std::vector<HeldRun>>;

// @param kind of the cases, for messages.
HeldRuns held_runs_of(const ComparedCores& cores, const std::string& kind, const std::vector<HardCase>& cases,
                      bool is_judged) {
  return of_both(cores, [&](const ComparedCore& core) {
    std::vector<HeldRun> runs;
    runs.reserve(cases.size());
    for (const HardCase& each : cases)
      runs.push_back(held_run_of(core.at(kind + " " + each.name), each, is_judged));
    return runs;
  });
}

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

HardCaseLine measure_hard_cases(const ComparedCores& cores, const CardRequest& request, bool is_judged) {
  // Both cores play those that are made by the constants of the base.
  const Core& core = cores.before.at("the hard cases");
  std::vector<HardCase> cases, runs;
  for (const NamedScenario& named : request.library)
    if (named.path.starts_with("hard/"))
      for (HardCase& hard_case : hard_cases_of(core, named.scenario))
        if (!hard_case.is_long) cases.push_back(std::move(hard_case));
  for (std::uint64_t number = 0; number < kRandomRuns; ++number) {
    RandomRun run = random_run(core, request.seed, number);
    runs.push_back(
        {.name = run.scenario.name, .scenario = std::move(run.scenario), .stops = std::move(run.stops)});
  }
  const HeldRuns held = held_runs_of(cores, "hard case", cases, is_judged);
  const HeldRuns random = held_runs_of(cores, "random run", runs, is_judged);
  return {.cases = std::ssize(cases),
          .other_cases = other_bits(held),
          .other_random_runs = {other_bits(random), std::ssize(runs)},
          .general = invariant_line(true, held, random),
          .listing = invariant_line(false, held, random)};
}

ClaimLine measure_claims(const ComparedCores& cores, const CostLine& cost) {
  constexpr double kNanosecond_s = 1e-9;
  const auto claims_by = [](const ComparedCore& core, const Band& step_ns) {
    return paper_claims(core.at("the paper's claims"), step_ns.median * kNanosecond_s);
  };
  const std::vector<Claim> before = claims_by(cores.before, cost.step_ns.before);
  const std::vector<Claim> after = claims_by(cores.after, cost.step_ns.after);
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

std::string lacking_text(const ComparedCores& cores) {
  const auto [base, candidate] = of_both(cores, [](const ComparedCore& core) { return core.lacking; });
  std::string text = base.empty() ? "" : "the base has no " + base;
  if (!candidate.empty())
    text += (text.empty() ? "the candidate has no " : "; the candidate has no ") + candidate;
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

std::vector<ScenarioChange> Card::moved_recordings() const {
  std::vector<ScenarioChange> moved;
  for (const ScenarioChange& changed : library.changed)
    if (is_recording(changed.path) && changed.change.end_shift_px > RestAnchor::kStill_px)
      moved.push_back(changed);
  return moved;
}

std::string rows_hash(const ComparedCore& core, const CardRequest& request) {
  StateHash hash;
  for (const NamedScenario& named : request.library) hash.add(run_of(named, core).hash);
  return hex(hash.value());
}

Card measure_card(const ComparedCores& cores, const CardRequest& request) {
  Card card{.seed = request.seed,
            .flings = request.flings,
            .scenarios = std::ssize(request.library),
            .lacking = lacking_text(cores),
            .cost = measure_cost(cores, request.seed, request.now_ns)};
  measure_library(cores, request, card);
  measure_flings(cores, card);
  card.displays = measure_displays(cores, request.seed, request.flings);
  card.rest = measure_rest(cores);
  card.hard_cases = measure_hard_cases(cores, request, card.lacking.empty());
  if (card.lacking.empty()) card.claims = measure_claims(cores, card.cost);
  card.step = step_line(request, card.has_other_bits());
  // Some state shows only after many calls.
  const auto require_same_rows = [&request](const ComparedCore& core, const std::string& hash) {
    if (rows_hash(core, request) != hash)
      throw CoreRefused(core.number, "does not repeat: scenarios played again by another process differ");
  };
  require_same_rows(cores.before, request.rows_hash.before);
  require_same_rows(cores.after, request.rows_hash.after);
  return card;
}

}  // namespace hyrax
