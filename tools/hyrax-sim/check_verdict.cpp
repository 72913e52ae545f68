#include "tools/hyrax-sim/check_verdict.h"

#include <chrono>

#include "tools/files/presence.h"
#include "tools/files/scenario_reader.h"
#include "tools/files/text_file.h"
#include "tools/hyrax-sim/golden_check.h"
#include "tools/hyrax-sim/run_expectations.h"
#include "tools/store/golden_digest.h"
#include "tools/store/golden_file.h"
#include "tools/store/golden_place.h"
#include "tools/store/golden_seal.h"

namespace hyrax {
namespace {

using Status = CheckVerdict::Status;

std::vector<Expectation> broken_of(const Scenario& scenario, const RunSummary& summary) {
  std::vector<Expectation> broken;
  for (Expectation& expectation : judge_run(scenario, summary))
    if (!expectation.holds) broken.push_back(std::move(expectation));
  return broken;
}

// The run's summary, and in the verdict what the golden file says of it.
RunSummary compare_rows(const Scenario& scenario, const GoldenPlace& place, CheckVerdict& verdict) {
  ComparedRun compared = compare_with(read_golden(place.h5_path), scenario);
  verdict.comparison = std::move(compared.comparison);
  return compared.summary;
}

// A blessing that was cut short leaves the new digest beside the old file.
void refuse_digest_of_another(const GoldenPlace& place, CheckVerdict& verdict) {
  if (!verdict.comparison.agrees) return;
  verdict.comparison.agrees = false;
  verdict.comparison.difference = DifferenceClass::shape;
  verdict.comparison.shape =
      place.txt_path + " is not of this golden file, as after a blessing cut short; bless the scenario again";
}

RunSummary compare_quickly(const Scenario& scenario, const GoldenPlace& place, CheckVerdict& verdict) {
  const RunSummary summary = play(scenario);
  const bool names_this_run = read_digest_hash(place.txt_path) == hex(summary.state_hash);
  if (names_this_run && seals(read_text_file(place.txt_path), place.h5_path)) return summary;
  compare_rows(scenario, place, verdict);
  if (!names_this_run) refuse_digest_of_another(place, verdict);
  return summary;
}

// A whole seal says that file and run agree in everything; the file is taken apart only where the
// seal is broken.
RunSummary compare_whole(const Scenario& scenario, const GoldenPlace& place, CheckVerdict& verdict) {
  const auto seal = is_there(place.txt_path) ? seal_in(read_text_file(place.txt_path)) : std::nullopt;
  if (!seal) return compare_rows(scenario, place, verdict);
  const FreshRun fresh = play_for_golden(scenario);
  const bool names_this_run = seal->contents == contents_hash(fresh.run);
  if (names_this_run && seal->file == file_hash(place.h5_path)) return fresh.summary;
  const RunSummary summary = compare_rows(scenario, place, verdict);
  if (!names_this_run) refuse_digest_of_another(place, verdict);
  return summary;
}

void judge_into(const Scenario& scenario, const CheckOptions& options, CheckVerdict& verdict) {
  const auto place = golden_place(verdict.path, options.golden_folder);
  verdict.golden_path = place ? place->h5_path : "";
  const bool has_golden = place && is_there(place->h5_path);
  const auto compare = options.is_quick ? compare_quickly : compare_whole;
  const RunSummary summary = has_golden ? compare(scenario, *place, verdict) : play(scenario);
  verdict.broken = broken_of(scenario, summary);
  const bool is_judged = has_golden || (scenario.expect && scenario.expect->state_hash);
  if (!is_judged)
    verdict.status = Status::missing;
  else if (!verdict.comparison.agrees || !verdict.broken.empty() || summary.non_finite_step)
    verdict.status = Status::disagreed;
}

ExitCode exit_code_of(Status status) {
  switch (status) {
    case Status::agreed:
      return ExitCode::agreed;
    case Status::disagreed:
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
  }
  return "";
}

CheckVerdict check_scenario(const std::string& path, const CheckOptions& options) {
  CheckVerdict verdict;
  verdict.path = path;
  const auto start = std::chrono::steady_clock::now();
  try {
    judge_into(load_scenario(path), options, verdict);
    verdict.exit_code = exit_code_of(verdict.status);
  } catch (const Failure& failure) {
    verdict.status = Status::failed;
    verdict.error = failure.what();
    verdict.exit_code = failure.exit_code();
  }
  verdict.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return verdict;
}

}  // namespace hyrax
