#include "tools/hyrax-sim/golden/check_verdict.h"

#include <chrono>
#include <exception>
#include <optional>

#include "tools/files/scenario_reader.h"
#include "tools/files/unreferenced_golden.h"
#include "tools/hyrax-replay/judged_run.h"
#include "tools/hyrax-sim/runs/paper_model.h"

namespace hyrax {
namespace {

using Status = CheckVerdict::Status;

void judge_into(const Scenario& scenario, const CheckOptions& options, CheckVerdict& verdict) {
  require_measurable(verdict.path, scenario);
  verdict.golden = golden_place(verdict.path, options.golden_folder);
  const bool has_golden = verdict.has_golden = verdict.golden && has_golden_file(*verdict.golden);
  auto pair = has_golden ? compare_with_pair(scenario, *verdict.golden, options.reads_golden)
                         : PairComparison{.summary = play(scenario)};
  verdict.is_open = !pair;
  if (!pair) return;
  verdict.comparison = std::move(pair->comparison);
  verdict.note = std::move(pair->note);
  verdict.runs = std::move(pair->runs);
  verdict.broken = broken_expectations(scenario, pair->summary);
  if (!has_golden && !has_state_hash_only(scenario, verdict.golden))
    verdict.status = Status::missing;
  else if (!verdict.comparison.agrees || !verdict.broken.empty() || pair->summary.non_finite_step)
    verdict.status = Status::disagreed;
}

void fail(CheckVerdict& verdict, ExitCode exit_code, const std::string& error) {
  verdict.status = Status::failed;
  verdict.error = error;
  verdict.exit_code = exit_code;
}

}  // namespace

CheckVerdict check_scenario(const std::string& path, const CheckOptions& options) {
  CheckVerdict verdict;
  verdict.path = path;
  verdict.golden_folder = options.golden_folder;
  const auto start = std::chrono::steady_clock::now();
  try {
    if (path == "-")
      throw Failure(ExitCode::bad_input, "-: standard input has no golden file; name a scenario file");
    judge_into(load_scenario(path), options, verdict);
    verdict.exit_code = exit_code_of(verdict.status);
  } catch (const Failure& failure) {
    fail(verdict, failure.exit_code(), failure.what());
  } catch (const std::exception& error) {  // Uncaught, it would terminate the program.
    fail(verdict, ExitCode::program_fault, path + ": internal error: " + error.what());
  }
  verdict.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return verdict;
}

std::vector<CheckVerdict> unreferenced_verdicts(const std::vector<std::string>& arguments,
                                                const std::string& golden_folder) {
  std::vector<CheckVerdict> verdicts;
  for (const UnreferencedGolden& golden : find_unreferenced(arguments, golden_folder)) {
    CheckVerdict& verdict = verdicts.emplace_back();
    verdict.path = golden.path;
    verdict.status = Status::unreferenced;
    verdict.exit_code = exit_code_of(verdict.status);
    if (!golden.error.empty()) fail(verdict, ExitCode::cannot_access, golden.error);
  }
  return verdicts;
}

}  // namespace hyrax
