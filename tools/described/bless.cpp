
#include "tools/app/library/blessing.h"
#include "tools/described/commands.h"
#include "tools/described/core_verdict.h"
#include "tools/described/scenario_json.h"
#include "tools/files/printable.h"

namespace hyrax {
namespace {

DescribedRun& run_of(ScenarioVerdict& verdict) { return static_cast<DescribedRun&>(verdict); }

class DescribedBlesser final : public Blesser {
 public:
  explicit DescribedBlesser(const DescribedCore& core) : core_(core) {}

  [[nodiscard]] std::shared_ptr<ScenarioVerdict> verdict() const override {
    return std::make_shared<DescribedRun>();
  }
  void parse(ScenarioVerdict& verdict, const std::string& text) const override {
    run_of(verdict).scenario = to_described_scenario(core_.description, parse_json(text, verdict.path),
                                                     verdict.path, fallback_name(verdict.path));
  }
  void compare(Blessing& blessing) const override {
    DescribedRun& run = run_of(*blessing.verdict);
    if (!blessing.unreadable.empty()) refuse_input(blessing.unreadable);
    judge_run(core_, run, {.golden_folder = run.golden->folder});
    if (run.comparison->is_proved) return;
    blessing.status = Blessing::Status::changed;
    if (!run.comparison->has_other_scenario || !run.comparison->fault.empty())
      blessing.differs_in = run.comparison->difference;
  }
  void compare_none(Blessing& blessing) const override {
    DescribedRun& run = run_of(*blessing.verdict);
    judge_run(core_, run, {.golden_folder = run.golden->folder, .compares = false});
  }
  void judge(ScenarioVerdict& verdict) const override { run_of(verdict).judge(core_.description); }
  void write_pair(const Blessing& blessing, const std::string& reason) const override {
    const DescribedRun& run = run_of(*blessing.verdict);
    write_golden_pair(core_, run.scenario, *run.golden, reason);
  }
  [[nodiscard]] std::shared_ptr<ScenarioVerdict> check(const std::string& path,
                                                       const std::string& golden_option) const override {
    return std::make_shared<DescribedRun>(judge_file(core_, path, {.golden_folder = golden_option}));
  }
  [[nodiscard]] AcceptedCore program_core() const override { return hyrax::program_core(core_); }
  [[nodiscard]] bool is_golden_h5(const std::string& path) const override {
    return hyrax::is_golden_h5(core_, path);
  }
  [[nodiscard]] BlessWords words(const BlessReport& report, const BlessRequest&) const override {
    BlessWords words;
    for (const Blessing& blessing : report.blessings) {
      if (!blessing.plays_otherwise()) continue;
      const ScenarioVerdict& run = *blessing.verdict;
      words.paragraphs.push_back(
          {.subject = printable(run.path) + ": ",
           .verdict = "differs",
           .predicate = ": " + (run.golden_fault.empty() ? run.consequence() : run.golden_fault)});
    }
    return words;
  }

 private:
  const DescribedCore& core_;
};

void declare(Options& options, BlessRequest& request) {
  declare_bless(options, request, "exact values", "print what differs in every scenario");
}

}  // namespace

Command described_bless_command(const DescribedCore& core) {
  return {
      .name = "bless",
      .summary = "accept current results as the new golden files, with a reason",
      .example = "hyrax-sim bless scenarios/first.json --reason 'a harder push'\n  hyrax-sim bless --prune",
      .is_common = true,
      .declare = with_request<BlessRequest>(
          declare, [&core](BlessRequest& request) { return bless(DescribedBlesser(core), request); })};
}

}  // namespace hyrax
