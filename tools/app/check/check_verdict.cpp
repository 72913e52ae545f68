#include "tools/app/check/check_verdict.h"

#include <chrono>
#include <exception>
#include <new>

#include "sim/cause/watched_core.h"
#include "sim/study/reference_model.h"
#include "sim/trace/step_program.h"
#include "tools/app/core/paper_model.h"
#include "tools/app/expect/judged_run.h"
#include "tools/files/non_finite_text.h"
#include "tools/files/path.h"
#include "tools/files/scenario_reader.h"
#include "tools/files/summary_text.h"
#include "tools/files/text_file.h"
#include "tools/files/unreferenced_golden.h"

namespace hyrax {
namespace {

void judge_into(const Core& core, const Scenario& scenario, const CheckOptions& options,
                CheckVerdict& verdict) {
  require_measurable(core, verdict.path, scenario);
  verdict.golden = golden_place(verdict.path, options.golden_folder);
  const bool has_golden = verdict.has_golden = verdict.golden && has_golden_file(*verdict.golden);
  const Core watched_core =
      watched(core, {options.watched_step}, [&](const StepInput& input, std::span<TracedBody> bodies) {
        bodies.front().update(input);
        verdict.paths_taken.insert(bodies.front().path());
      });
  const Core& playing = options.watched_step ? watched_core : core;
  auto pair = has_golden ? compare_with_pair(core, scenario, *verdict.golden, options.reads_golden, playing)
                         : PairComparison{.summary = play(playing, scenario)};
  verdict.is_open = !pair;
  if (!pair) return;
  verdict.comparison = std::move(pair->comparison);
  verdict.note = std::move(pair->note);
  verdict.runs = std::move(pair->runs);
  verdict.broken = broken_expectations(core, scenario, pair->summary, reference_model(core));
  if (!has_golden) verdict.state_hash = hex(pair->summary.state_hash);
  verdict.non_finite = non_finite_text(scenario, pair->summary.final);
  if (!has_golden && !has_state_hash_only(scenario, verdict.golden))
    verdict.status = CheckStatus::missing;
  else if (!verdict.comparison.agrees || !verdict.broken.empty() || !verdict.non_finite.empty())
    verdict.status = CheckStatus::disagreed;
}

void fail(CheckVerdict& verdict, ExitCode exit_code, const std::string& error) {
  verdict.status = CheckStatus::failed;
  verdict.error = error;
  verdict.exit_code = exit_code;
}

// Empty for half a golden file, or one that cannot be read.
std::string stored_state_hash(const GoldenPlace& place) try {
  return is_regular_file(place.h5_path) && is_regular_file(place.txt_path)
             ? summary_state_hash(read_text_file(place.txt_path))
             : "";
} catch (const Failure&) {
  return "";
}

}  // namespace

CheckVerdict check_scenario(const Core& core, const std::string& path, const CheckOptions& options) {
  CheckVerdict verdict;
  verdict.path = path;
  verdict.golden_option = options.golden_folder;
  verdict.golden_folder = golden_folder_of(path, options.golden_folder);
  const auto start = std::chrono::steady_clock::now();
  try {
    if (path == "-") refuse_input("-: standard input has no golden file; name a scenario file");
    judge_into(core, load_scenario(path), options, verdict);
    verdict.exit_code = exit_code_of(verdict.status);
  } catch (const Failure& failure) {
    fail(verdict, failure.exit_code(), failure.what());
  } catch (const std::bad_alloc&) {
    verdict.is_open = !options.reads_golden;  // Alone it has more memory.
    if (!verdict.is_open) fail(verdict, ExitCode::program_fault, path + ": out of memory");
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
    verdict.is_scenario = false;
    verdict.status = CheckStatus::unreferenced;
    verdict.exit_code = exit_code_of(verdict.status);
    verdict.state_hash = stored_state_hash({golden.path + ".h5", golden.path + ".txt"});
    if (!golden.error.empty()) fail(verdict, ExitCode::cannot_access, golden.error);
  }
  return verdicts;
}

}  // namespace hyrax
