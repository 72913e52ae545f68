#include "tools/hyrax-sim/check_verdict.h"

#include <chrono>
#include <exception>
#include <optional>

#include "tools/files/path.h"
#include "tools/files/scenario_reader.h"
#include "tools/hyrax-sim/golden_pair.h"
#include "tools/hyrax-sim/run_expectations.h"

namespace hyrax {
namespace {

using Status = CheckVerdict::Status;

std::vector<Expectation> broken_of(const Scenario& scenario, const RunSummary& summary) {
  std::vector<Expectation> broken;
  for (Expectation& expectation : judge_run(scenario, summary))
    if (!expectation.holds) broken.push_back(std::move(expectation));
  return broken;
}

// A half of a golden file is never replaced by a state hash in `expect`: it was changed after its blessing.
bool is_judged_without_golden(const Scenario& scenario, const std::optional<GoldenPlace>& place) {
  const bool has_half = place && (is_there(place->h5_path) || is_there(place->txt_path));
  return !has_half && scenario.expect && scenario.expect->state_hash;
}

void judge_into(const Scenario& scenario, const CheckOptions& options, CheckVerdict& verdict) {
  verdict.golden = golden_place(verdict.path, options.golden_folder);
  const bool has_golden = verdict.golden && has_golden_file(*verdict.golden);
  auto pair = has_golden ? compare_with_pair(scenario, *verdict.golden, options.reads_golden)
                         : PairComparison{.summary = play(scenario)};
  verdict.is_open = !pair;
  if (!pair) return;
  verdict.comparison = std::move(pair->comparison);
  verdict.note = std::move(pair->note);
  verdict.broken = broken_of(scenario, pair->summary);
  if (!has_golden && !is_judged_without_golden(scenario, verdict.golden))
    verdict.status = Status::missing;
  else if (!verdict.comparison.agrees || !verdict.broken.empty() || pair->summary.non_finite_step)
    verdict.status = Status::disagreed;
}

ExitCode exit_code_of(Status status) {
  switch (status) {
    case Status::agreed:
      return ExitCode::agreed;
    case Status::disagreed:
    case Status::unreferenced:
      return ExitCode::disagreed;
    case Status::missing:
      return ExitCode::golden_missing;
    case Status::failed:
      break;
  }
  return ExitCode::program_fault;
}

}  // namespace

std::string_view name_of(Status status) {
  switch (status) {
    case Status::agreed:
      return "agreed";
    case Status::disagreed:
      return "disagreed";
    case Status::missing:
      return "missing";
    case Status::failed:
      return "failed";
    case Status::unreferenced:
      return "unreferenced";
  }
  return "";
}

CheckVerdict check_scenario(const std::string& path, const CheckOptions& options) {
  CheckVerdict verdict;
  verdict.path = path;
  verdict.golden_folder = options.golden_folder;
  const auto start = std::chrono::steady_clock::now();
  try {
    judge_into(load_scenario(path), options, verdict);
    verdict.exit_code = exit_code_of(verdict.status);
  } catch (const Failure& failure) {
    verdict.status = Status::failed;
    verdict.error = failure.what();
    verdict.exit_code = failure.exit_code();
  } catch (const std::exception& error) {  // It would end a thread, and the program with it.
    verdict.status = Status::failed;
    verdict.error = path + ": internal error: " + error.what();
    verdict.exit_code = ExitCode::program_fault;
  }
  verdict.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return verdict;
}

}  // namespace hyrax
