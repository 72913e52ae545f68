#include "tools/hyrax-sim/check_verdict.h"

#include <chrono>
#include <exception>
#include <optional>

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

// Where a golden pair whose rows agree is not as it was blessed, in words; nothing where the file's bytes
// alone are other ones: another build's provenance, or the same contents laid out anew.
std::optional<std::string> fault_of_words(const std::string& kept, const std::string& fresh_digest,
                                          const std::string& contents, const GoldenPlace& place) {
  const auto seal = seal_in(kept);
  const std::string file = seal ? seal->file : file_hash(place.h5_path);
  if (const auto fault = digest_fault(kept, fresh_digest + seal_line({contents, file})))
    return place.txt_path + ": " + *fault;
  return golden_words_fault(place.h5_path);
}

// A whole digest, its seal included, says that file and run agree in everything; the file is taken
// apart only where the digest is not what blessing the run would write, as after a blessing cut short.
// Nothing where it would have to be, and is not to be.
std::optional<RunSummary> compare_whole(const Scenario& scenario, const GoldenPlace& place,
                                        const CheckOptions& options, CheckVerdict& verdict) {
  const bool has_digest = is_there(place.txt_path);
  if (!has_digest && !options.reads_golden) return std::nullopt;
  if (!has_digest) return compare_rows(scenario, place, verdict);
  const std::string kept = read_text_file(place.txt_path);
  const FreshRun fresh = play_for_golden(scenario);
  const std::string digest =
      golden_digest_text(fresh.run, fresh.summary, digest_reason(kept), digest_margin(kept));
  const std::string contents = contents_hash(fresh.run);
  if (!digest_fault(kept, digest + seal_line({contents, file_hash(place.h5_path)}))) return fresh.summary;
  if (!options.reads_golden) return std::nullopt;
  const RunSummary summary = compare_rows(scenario, place, verdict);
  if (!verdict.comparison.agrees) return summary;
  if (const auto fault = fault_of_words(kept, digest, contents, place)) {
    verdict.comparison.agrees = false;
    verdict.comparison.difference = DifferenceClass::shape;
    verdict.comparison.shape =
        "all rows agree, but the golden file and its digest are not as they were blessed: " + *fault +
        "; restore both, or bless the scenario again";
  } else {
    verdict.note = place.h5_path + ": agrees, but its bytes are not those that " + place.txt_path +
                   " seals: its provenance or its layout is another";
  }
  return summary;
}

std::optional<RunSummary> compare_quickly(const Scenario& scenario, const GoldenPlace& place,
                                          const CheckOptions& options, CheckVerdict& verdict) {
  const RunSummary summary = play(scenario);
  const bool names_this_run = read_digest_hash(place.txt_path) == hex(summary.state_hash);
  const bool is_whole = names_this_run && seals(read_text_file(place.txt_path), place.h5_path);
  return is_whole ? summary : compare_whole(scenario, place, options, verdict);
}

void judge_into(const Scenario& scenario, const CheckOptions& options, CheckVerdict& verdict) {
  const auto place = golden_place(verdict.path, options.golden_folder);
  verdict.golden_path = place ? place->h5_path : "";
  const bool has_golden = place && has_golden_file(*place);
  const auto compare = options.is_quick ? compare_quickly : compare_whole;
  const std::optional<RunSummary> summary =
      has_golden ? compare(scenario, *place, options, verdict) : play(scenario);
  verdict.is_open = !summary;
  if (!summary) return;
  verdict.broken = broken_of(scenario, *summary);
  const bool is_judged = has_golden || (scenario.expect && scenario.expect->state_hash);
  if (!is_judged)
    verdict.status = Status::missing;
  else if (!verdict.comparison.agrees || !verdict.broken.empty() || summary->non_finite_step)
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
  } catch (const std::exception& error) {  // It would end a thread, and the program with it.
    verdict.status = Status::failed;
    verdict.error = path + ": a fault of the program itself: " + error.what();
    verdict.exit_code = ExitCode::program_fault;
  }
  verdict.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return verdict;
}

}  // namespace hyrax
