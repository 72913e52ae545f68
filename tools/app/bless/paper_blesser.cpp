#include "tools/app/bless/paper_blesser.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/cause/cause_groups.h"
#include "sim/trajectory/physics_model.h"
#include "tools/app/causes/core_check.h"
#include "tools/app/check/check_verdict.h"
#include "tools/app/core/core_requirements.h"
#include "tools/app/expect/judged_run.h"
#include "tools/files/non_finite_text.h"
#include "tools/files/scenario_reader.h"
#include "tools/files/text_file.h"
#include "tools/platform/atomic_file.h"
#include "tools/run_core/run_core.h"
#include "tools/store/golden_file.h"
#include "tools/store/golden_summary.h"

namespace hyrax {
namespace {

struct BlessedRun final : PairVerdict {
  Scenario scenario;  ///< As it is blessed.
  Core core;          ///< That plays it.
};
BlessedRun& run_of(ScenarioVerdict& verdict) { return static_cast<BlessedRun&>(verdict); }

// Where results that were accepted under a model's name change by more than rounding; not where only a golden
// file or a scenario was edited, since the model's results are then the same.
std::string model_hint(const Core& core, const std::vector<DifferenceGroup>& groups) {
  const bool is_due = std::ranges::any_of(groups, [&core](const DifferenceGroup& group) {
    return group.difference > DifferenceClass::rounding && group.cause.kind != CauseKind::golden &&
           group.cause.kind != CauseKind::scenario &&
           std::ranges::any_of(group.scenarios, [&core](const ScenarioVerdict* verdict) {
             const auto& runs = pair_of(*verdict).runs;
             return runs && runs->golden.physics == core.name;
           });
  });
  if (!is_due || !is_paper_model(core.name)) return "";
  return fmt::format(
      "results change by more than rounding: give the physics model a new number (now {}; kPhysicsModel in "
      "sim/trajectory/physics_model.h)\n",
      kPhysicsModel);
}

class PaperBlesser final : public Blesser {
 public:
  explicit PaperBlesser(const Core& core) : core_(core) {}

  [[nodiscard]] std::shared_ptr<ScenarioVerdict> verdict() const override {
    return std::make_shared<BlessedRun>();
  }

  void parse(ScenarioVerdict& verdict, const std::string& text) const override {
    BlessedRun& run = run_of(verdict);
    run.scenario = parse_scenario_file(text, run.path);
    run.core = run_core(core_, run.path, run.scenario);
    require_measurable(run.core, run.path, run.scenario);
  }

  void compare(Blessing& blessing) const override {
    BlessedRun& run = run_of(*blessing.verdict);
    PairComparison pair = *compare_with_pair(run.core, run.scenario, *run.golden, true, run.core);
    blessing.status =
        pair.is_proved || pair.is_kept ? Blessing::Status::unchanged : Blessing::Status::changed;
    blessing.keeps_h5 = has_golden_file(*run.golden) && blessing.status == Blessing::Status::changed &&
                        is_h5_current(run.core, run.scenario, *run.golden);
    if (pair.is_proved) renew_older_layout(blessing);
    static_cast<PairComparison&>(run) = std::move(pair);
    run.state_hash = hex(run.summary.state_hash);
    const bool is_of_scenario =
        run.runs && plays_the_same(run.runs->golden.scenario, run.runs->fresh.scenario);
    if (is_of_scenario || !run.gives_its_rows) blessing.differs_in = run.comparison.difference;
  }

  void compare_none(Blessing& blessing) const override {
    BlessedRun& run = run_of(*blessing.verdict);
    run.comparison.agrees = blessing.unreadable.empty();
    if (!run.comparison.agrees) run.comparison.difference = DifferenceClass::shape;
    run.summary = play(run.core, run.scenario);
    run.state_hash = hex(run.summary.state_hash);
  }

  void judge(ScenarioVerdict& verdict) const override {
    BlessedRun& run = run_of(verdict);
    run.expects_hash = run.scenario.expect && run.scenario.expect->state_hash;
    run.broken = broken_expectations(run.core, run.scenario, run.summary);
    const std::string non_finite = non_finite_text(run.scenario, run.summary.final);
    if (!non_finite.empty())
      run.faults = {non_finite};
    else if (play(run.core, run.scenario).state_hash != run.summary.state_hash)
      run.faults = {std::string(kNotRepeated)};
  }

  void write_pair(const Blessing& blessing, const std::string& reason) const override {
    const BlessedRun& run = run_of(*blessing.verdict);
    const auto& [h5_path, txt_path, is_reserved, folder] = *run.golden;
    const FreshRun fresh = play_for_golden(run.core, run.scenario, run.core);
    const std::string core_name = core_.record.checksum();
    if (blessing.keeps_h5)
      return write_text_file(txt_path,
                             summary_of(run.core, fresh, reason, file_checksum(h5_path), core_name));
    AtomicFile rows(h5_path);
    AtomicFile summary(txt_path);
    write_golden(rows, h5_path, fresh.run);
    summary.write(summary_of(run.core, fresh, reason, file_checksum(rows.part_path()), core_name));
    // The rows come last: until they are there, `check` compares with the old ones and reports it.
    summary.commit();
    rows.commit();
  }

  [[nodiscard]] std::shared_ptr<ScenarioVerdict> check(const std::string& path,
                                                       const std::string& golden_option) const override {
    auto verdict =
        std::make_shared<CheckVerdict>(check_scenario(core_, path, {.golden_folder = golden_option}));
    if (verdict->status != CheckStatus::agreed) return verdict;
    const Scenario scenario = load_scenario(path);
    if (play(run_core(core_, path, scenario), scenario).state_hash != verdict->summary.state_hash)
      verdict->faults = {std::string(kNotRepeated)};
    return verdict;
  }

  [[nodiscard]] AcceptedCore program_core() const override { return hyrax::program_core(core_); }

  [[nodiscard]] std::string unnoticed(const Library& library) const override {
    CoreCheck differences(core_, library.golden_folder, {});
    differences.judge_differences({library.scenarios_folder}, 0);
    return differences.verdict().unnoticed.empty() ? "" : core_text(differences.verdict());
  }

  [[nodiscard]] bool is_golden_h5(const std::string& path) const override try {
    static_cast<void>(read_golden(path));
    return true;
  } catch (const Failure&) {
    return false;
  }

  [[nodiscard]] BlessWords words(const BlessReport& report, const BlessRequest& request) const override {
    std::vector<const PairVerdict*> differing;
    for (const Blessing& blessing : report.blessings)
      if (blessing.plays_otherwise()) differing.push_back(&run_of(*blessing.verdict));
    CoreChecks cores(core_, request.files, request.golden_folder);
    const std::vector<DifferenceGroup> groups = group_by_cause(differing, cores);
    std::vector<std::string> texts;
    for (const CoreVerdict* const verdict : cores.verdicts())
      texts.push_back(core_text(*verdict, cores.verdicts().size() == 1, groups.empty()));
    BlessWords words{difference_paragraphs(groups, texts, report.blessings.size()),
                     list_of(groups, group_json)};
    words.paragraphs.push_back({.lines = model_hint(core_, groups)});
    return words;
  }

 private:
  // A summary of an older layout says something else of the same run.
  void renew_older_layout(Blessing& blessing) const {
    const BlessedRun& run = run_of(*blessing.verdict);
    std::string renewed = renewed_summary(run.core, run.scenario, *run.golden);
    if (renewed == read_text_file(run.golden->txt_path)) return;
    blessing.status = Blessing::Status::changed;
    blessing.keeps_h5 = true;
    blessing.renewed_summary = std::move(renewed);
  }

  const Core& core_;
};

}  // namespace

std::unique_ptr<Blesser> blesser_of(const Core& core) { return std::make_unique<PaperBlesser>(core); }

}  // namespace hyrax
