#include "tools/app/causes/core_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "sim/cause/constant_change.h"
#include "sim/cause/run_match.h"
#include "sim/cause/watched_kernel.h"
#include "sim/compare/run_distance.h"
#include "sim/replay/core_constants.h"
#include "sim/replay/traced_kernel.h"
#include "sim/result/figure.h"
#include "sim/search/shrink.h"
#include "sim/trace/step_difference.h"
#include "sim/trace/step_text.h"
#include "sim/trajectory/physics_model.h"
#include "tools/app/expect/judged_run.h"
#include "tools/files/scenario_list.h"
#include "tools/files/scenario_reader.h"
#include "tools/files/scenario_writer.h"
#include "tools/files/table_text.h"

namespace hyrax {
namespace {

// The search for a step that shows a difference: the same on every machine.
constexpr std::uint64_t kSearchSeed = 1;
constexpr std::int64_t kSearchSteps = 300'000;
constexpr std::size_t kSearchedMax = 8;  // Of many differences the first are searched for.
constexpr double kConsequence_s = 5.0;
constexpr std::int64_t kConsequenceSteps = 100'000;
constexpr std::int64_t kShrinkTrials = 500;

// IEEE-754 does not fix the bits of other functions.
bool depends_on_library(const Expression& expression) {
  constexpr std::array<std::string_view, 16> kExact = {
      "fabs", "abs",       "sqrt",     "fma",  "floor", "ceil", "trunc",     "round",
      "rint", "nearbyint", "copysign", "fmin", "fmax",  "fmod", "remainder", "signbit"};
  return expression.op == Operator::call && std::ranges::find(kExact, expression.name) == kExact.end();
}

// One step from `input`.
Scenario scenario_of(const StepInput& input) {
  const auto& [state, window, sprite, is_held] = input.world;
  const double rate_hz = std::round(1.0 / input.dt_s);
  Scenario scenario = scenario_from(state, window, sprite, rate_hz, 1);
  scenario.name = "unnoticed";
  if (!(input.dt_s > 0.0 && rate_hz >= 1.0 && 1.0 / rate_hz == input.dt_s))
    scenario.clock.base = FixedStep{input.dt_s};
  return scenario;
}

// The same for the same scenario, so that files of different ones do not replace each other.
std::string name_of(const Scenario& scenario) {
  const std::string text = scenario_file_text(scenario);
  ByteHash hash;
  hash.add(std::as_bytes(std::span(text.data(), text.size())));
  return "unnoticed-" + hex(hash.value()).substr(0, 8);
}

std::string consequence_of(Scenario scenario, double dt_s, const Kernel& accepted, const Kernel& program) {
  const double steps = dt_s > 0.0 ? std::ceil(kConsequence_s / dt_s) : 1.0;
  scenario.length = static_cast<std::int64_t>(std::min(steps, static_cast<double>(kConsequenceSteps)));
  const RunSummary before = play(scenario, accepted);
  const RunSummary after = play(scenario, program);
  const double apart_px = distance_px(state_of(before.final), state_of(after.final));
  if (after.non_finite_step) return fmt::format("not finite from step {}", *after.non_finite_step);
  return fmt::format("after {:.3g} s {:.3g} px apart", after.final.t_s, apart_px);
}

std::vector<HeaderChange> header_changes_of(const CoreVerdict& verdict) {
  std::vector<HeaderChange> changes;
  for (const CoreChange& change : verdict.changes) changes.push_back(change.change);
  return changes;
}

}  // namespace

// The traced steps, where they are complete, and what plays them.
struct CoreCheck::Steps {
  std::optional<TracedStep> accepted, program;
  std::unique_ptr<const Kernel> accepted_kernel;
};

CoreCheck::~CoreCheck() = default;
CoreCheck::CoreCheck(CoreCheck&&) noexcept = default;

CoreCheck::CoreCheck(const std::string& golden_folder, const std::string& accept_command)
    : steps_(std::make_unique<Steps>()) {
  verdict_.golden_folder = golden_folder;
  const AcceptedCore program = program_core();
  if (!program.step.empty()) steps_->program = read_step(program.step);
  if (steps_->program)
    verdict_.paths = static_cast<std::int64_t>(steps_->program->paths_of(CoreFunction::update).size());
  try {
    accepted_ = read_accepted_core(golden_folder);
  } catch (const Failure& failure) {
    verdict_.why = failure.what();
    verdict_.exit_code = failure.exit_code();
    if (verdict_.exit_code == ExitCode::disagreed)
      verdict_.why += ", or accept this program's core: " + accept_command;
    return;
  }
  if (!accepted_) {
    verdict_.why = fmt::format("no accepted core in {}; to accept this program's: {}",
                               accepted_core_folder(golden_folder), accept_command);
    return;
  }
  compare();
}

void CoreCheck::compare() {
  const AcceptedCore program = program_core();
  if (!is_same_model(accepted_->model, program.model)) {
    verdict_.status = CoreStatus::not_proved;
    verdict_.why = fmt::format("the accepted core is of another class (found {}); this program's is {}",
                               accepted_->model, program.model);
    return;
  }
  if (!accepted_->step.empty()) steps_->accepted = read_step(accepted_->step);
  if (steps_->accepted) steps_->accepted_kernel = make_traced_kernel(*steps_->accepted);
  for (HeaderChange& change : header_changes(accepted_->header, program.header))
    verdict_.changes.push_back({std::move(change), std::nullopt});
  if (accepted_->header == program.header && accepted_->step == program.step) {
    verdict_.status = CoreStatus::accepted;
    return;
  }
  const StepProof proof = prove_equal("the accepted core", accepted_->record(), core_record());
  verdict_.status = proof.is_equal ? CoreStatus::proved_equal : CoreStatus::not_proved;
  verdict_.why = proof.why;
}

CauseBase CoreCheck::base() const {
  const std::vector<HeaderChange> changes = header_changes_of(verdict_);
  return {
      .program = core_kernel(),
      .accepted = steps_->accepted_kernel.get(),
      .why_not_played = why_not_played(),
      .is_same_core = verdict_.status == CoreStatus::accepted || verdict_.status == CoreStatus::proved_equal,
      .core_change =
          changes.empty()
              ? "the core's step changed, its header did not: an included header or a compiler option"
              : changes_sentence(changes),
      .calls_libm =
          steps_->accepted && std::ranges::any_of(steps_->accepted->expressions, depends_on_library)};
}

std::string CoreCheck::why_not_played() const {
  if (!accepted_ || verdict_.status == CoreStatus::none) return verdict_.why;
  return "the accepted core cannot be played: " + (accepted_->step.empty() ? accepted_->why_incomplete
                                                   : steps_->accepted
                                                       ? "it has members besides x, y, vx and vy"
                                                       : verdict_.why);
}

bool CoreCheck::covers(const std::string& core_name) const {
  return accepted_ && accepted_->covers(core_name);
}

void CoreCheck::take_core_runs(const std::vector<const StoredRun*>& fresh) {
  if (fresh.empty()) return;
  verdict_.status = CoreStatus::changed;
  verdict_.why.clear();
  if (!steps_->accepted_kernel || !steps_->program) return;
  TracedStep all = *steps_->accepted;
  for (const CoreChange& change : verdict_.changes)
    if (change.change.kind == HeaderChangeKind::constant)
      all = with_constant(all, change.change.from.value, change.change.to.value);
  if (all != *steps_->program) return;  // Something else changed, too: a constant alone proves nothing.
  for (CoreChange& change : verdict_.changes) {
    if (change.change.kind != HeaderChangeKind::constant) continue;
    const auto alone = make_traced_kernel(
        with_constant(*steps_->accepted, change.change.from.value, change.change.to.value));
    change.scenarios = std::ranges::count_if(
        fresh, [&](const StoredRun* run) { return match(*alone, run->scenario, *run).rows; });
  }
}

void CoreCheck::judge_differences(const std::string& scenarios_folder) {
  const bool is_open = verdict_.status == CoreStatus::changed || verdict_.status == CoreStatus::not_proved;
  if (!is_open || !steps_->accepted_kernel || !steps_->program) return;
  const StepPair pair(*steps_->accepted, *steps_->program);
  std::vector<bool> noticed(pair.differences().size());
  const auto is_all_noticed = [&] { return std::ranges::find(noticed, false) == noticed.end(); };
  const WatchedKernel watched(*steps_->accepted_kernel, [&](const StepInput& input) {
    if (!is_all_noticed()) pair.notice(input, noticed);
  });
  std::vector<UnlistedFolder> unlisted;
  for (const std::string& path : list_scenarios({scenarios_folder}, unlisted)) try {
      if (is_all_noticed()) break;
      static_cast<void>(play(load_scenario(path), watched));
    } catch (const Failure&) {  // Whoever checks it reports it.
    }
  if (std::ranges::find(noticed, true) != noticed.end()) verdict_.status = CoreStatus::changed;
  std::size_t searched = 0;
  std::vector<bool> shown(noticed.size());  // By the step that was found last.
  for (std::size_t index = 0; index < noticed.size(); ++index) {
    if (noticed[index]) continue;
    if (shown[index]) {
      UnnoticedDifference again = verdict_.unnoticed.back();
      again.text = pair.differences()[index].text;
      verdict_.unnoticed.push_back(std::move(again));
      continue;
    }
    const std::int64_t steps = ++searched > kSearchedMax ? 0 : kSearchSteps;
    const DifferenceSearch search = pair.search(index, kSearchSeed, steps);
    UnnoticedDifference& unnoticed = verdict_.unnoticed.emplace_back();
    unnoticed.text = pair.differences()[index].text;
    unnoticed.steps_tried = search.steps_tried;
    shown.assign(noticed.size(), false);
    if (!search.found) continue;
    pair.notice(*search.found, shown);
    const Kernel& accepted = *steps_->accepted_kernel;
    const auto differs = [&](const Scenario& scenario) {
      return play(scenario, accepted).state_hash != play(scenario, core_kernel()).state_hash;
    };
    unnoticed.scenario = shrink(scenario_of(*search.found), differs, {.trials_max = kShrinkTrials}).scenario;
    unnoticed.consequence = consequence_of(*unnoticed.scenario, search.found->dt_s, accepted, core_kernel());
    unnoticed.scenario->name = name_of(*unnoticed.scenario);
    verdict_.status = CoreStatus::changed;
    verdict_.exit_code = more_serious(verdict_.exit_code, ExitCode::disagreed);
  }
  if (verdict_.status == CoreStatus::changed)
    verdict_.why.clear();
  else if (!verdict_.unnoticed.empty())
    verdict_.why = fmt::format("{} steps tried, none of other bits", verdict_.unnoticed.front().steps_tried);
  else if (!pair.are_setters_equal())
    verdict_.why = "the constructor or a setter is another one, and no scenario shows it";
}

std::string core_text(const CoreVerdict& verdict) {
  switch (verdict.status) {
    case CoreStatus::accepted:
      return "";
    case CoreStatus::none:
      return fmt::format("core: {}\n", verdict.why);
    case CoreStatus::proved_equal:
      return "core: changed in text only: proved equal to the accepted core, the same operations on every "
             "path\n";
    case CoreStatus::changed:
    case CoreStatus::not_proved:
      break;
  }
  std::string text;
  if (verdict.status == CoreStatus::not_proved)
    text += fmt::format("core: not proved equal to the accepted one: {}\n", verdict.why);
  else
    text += "core: changed\n";
  for (const auto& [change, scenarios] : verdict.changes)
    text += fmt::format("  {}{}\n", change_text(change),
                        scenarios ? fmt::format("; alone reproduces {}", *scenarios) : "");
  std::string last;  // The scenario that was printed last.
  for (const UnnoticedDifference& unnoticed : verdict.unnoticed) {
    if (unnoticed.scenario && unnoticed.scenario->name == last) {
      text += fmt::format("  no scenario notices `{}` either; the same one shows it\n", unnoticed.text);
      continue;
    }
    last = unnoticed.scenario ? unnoticed.scenario->name : "";
    if (!unnoticed.scenario)
      text += fmt::format("  no scenario notices `{}`; {} steps tried, none of other bits\n", unnoticed.text,
                          unnoticed.steps_tried);
    else
      text += fmt::format("  no scenario notices `{}`, which changes results: {} in this one\n    {}\n",
                          unnoticed.text, unnoticed.consequence, to_text(to_json(*unnoticed.scenario), {}));
  }
  return text;
}

Json core_json(const CoreVerdict& verdict) {
  Table changes = changes_table(header_changes_of(verdict));
  changes.columns.push_back(
      column_of("scenarios", "", "that it reproduces alone", verdict.changes, [](const CoreChange& change) {
        return change.scenarios ? static_cast<double>(*change.scenarios) : kNotGiven;
      }));
  Json::Array unnoticed;
  for (const UnnoticedDifference& one : verdict.unnoticed)
    unnoticed.push_back(Json::Object{{"difference", one.text},
                                     {"scenario", one.scenario ? to_json(*one.scenario) : Json()},
                                     {"steps_tried", one.steps_tried}});
  return Json::Object{{"golden", verdict.golden_folder},
                      {"status", kCoreStatusNames[static_cast<std::size_t>(verdict.status)]},
                      {"why", verdict.why.empty() ? Json() : Json(verdict.why)},
                      {"paths", or_null(verdict.paths)},
                      {"paths_taken", std::ssize(verdict.paths_taken)},
                      {"changes", json_of(changes)},
                      {"unnoticed", std::move(unnoticed)}};
}

}  // namespace hyrax
