#include "tools/hyrax-replay/check.h"

#include "sim/trajectory/state_hash.h"
#include "tools/app/expect/judged_run.h"
#include "tools/files/check_status.h"
#include "tools/files/golden_place.h"
#include "tools/files/non_finite_text.h"
#include "tools/files/printable.h"
#include "tools/files/scenario_list.h"
#include "tools/files/scenario_reader.h"
#include "tools/files/summary_text.h"
#include "tools/files/text_file.h"
#include "tools/run_core/run_core.h"

namespace hyrax {
namespace {

struct ScenarioVerdict {
  std::string path;
  CheckStatus status = CheckStatus::agreed;
  std::string sentence = {};  // Why it does not agree.
  ExitCode exit_code = ExitCode::agreed;
  bool is_folder = false;  // That failed; it is no scenario.
};

// What is wrong with the summary, or differs from it; empty: it has this state hash.
std::string difference_from(const std::string& txt_path, const std::string& state_hash) {
  const std::string text = read_text_file(txt_path);
  const std::string found = summary_state_hash(text);
  const char* const damage = text.find("\r\n") != std::string::npos ? kConvertedLineEnds
                             : found.empty()                ? "has no line `state hash: ` with 32 hex digits"
                             : !summary_file_checksum(text) ? "does not end with its line `checksums: `"
                                                            : nullptr;
  if (damage != nullptr)
    return "the golden file was changed since it was blessed: " + txt_path + ": " + damage +
           "; restore it, or bless the scenario again";
  if (found == state_hash) return "";
  return txt_path + ": state hash differs (found " + found + "); the run has " + state_hash +
         "; `hyrax-sim check` finds the cause";
}

void add_sentence(std::string& sentences, const std::string& sentence) {
  if (!sentence.empty()) sentences += (sentences.empty() ? "" : "; ") + sentence;
}

void judge_into(const Core& own_core, const Scenario& scenario, const std::string& golden_folder,
                ScenarioVerdict& verdict) {
  const Core core = run_core(own_core, verdict.path, scenario);
  const auto place = golden_place(verdict.path, golden_folder);
  const bool has_golden = place && has_golden_file(*place);
  const RunSummary summary = play(core, scenario);
  verdict.sentence = non_finite_text(scenario, summary.final);
  if (!has_golden && !is_judged_by_hash(scenario.expect && scenario.expect->state_hash, place)) {
    verdict.status = CheckStatus::missing;
    add_sentence(verdict.sentence, missing_golden_sentence(place) +
                                       (verdict.sentence.empty() ? "; `hyrax-sim bless` creates it" : ""));
    return;
  }
  if (has_golden) add_sentence(verdict.sentence, difference_from(place->txt_path, hex(summary.state_hash)));
  add_sentence(verdict.sentence, broken_sentence(broken_expectations(core, scenario, summary)));
  if (!verdict.sentence.empty()) verdict.status = CheckStatus::disagreed;
}

void fail(ScenarioVerdict& verdict, const Failure& failure) {
  verdict.status = CheckStatus::failed;
  verdict.sentence = failure.what();
  verdict.exit_code = failure.exit_code();
}

ScenarioVerdict verdict_on(const Core& core, const std::string& path, const std::string& golden_folder) {
  ScenarioVerdict verdict{.path = path};
  const auto failure = failure_of(path, [&] {
    judge_into(core, load_scenario(path), golden_folder, verdict);
    verdict.exit_code = exit_code_of(verdict.status);
  });
  if (failure) fail(verdict, *failure);
  return verdict;
}

ScenarioVerdict verdict_on(const UnreferencedGolden& golden) {
  ScenarioVerdict verdict{.path = golden.path,
                          .status = CheckStatus::unreferenced,
                          .sentence = kUnreferencedSentence,
                          .exit_code = exit_code_of(CheckStatus::unreferenced),
                          .is_folder = !golden.error.empty()};
  if (verdict.is_folder) fail(verdict, Failure(ExitCode::cannot_access, golden.error));
  return verdict;
}

}  // namespace

ExitCode check(const Core& core, std::vector<std::string> files, const std::string& golden_folder) {
  set_default_folder(files);
  std::vector<Failure> unlisted;
  const std::vector<std::string> paths = list_scenarios(files, unlisted);
  const std::vector<UnreferencedGolden> unreferenced = find_unreferenced(files, golden_folder);
  if (paths.empty() && unreferenced.empty()) throw unlisted.front();
  std::vector<CheckStatus> statuses;
  std::int64_t folders_failed = 0;
  ExitCode exit_code = ExitCode::agreed;
  const auto report = [&](const ScenarioVerdict& verdict) {
    if (verdict.is_folder)
      ++folders_failed;
    else
      statuses.push_back(verdict.status);
    exit_code = more_serious(exit_code, verdict.exit_code);
    if (verdict.status != CheckStatus::agreed)
      print_text(printable(verdict.path) + ": " + std::string(name_of(verdict.status)) + ": " +
                 printable(verdict.sentence) + "\n");
  };
  for (const std::string& path : paths) report(verdict_on(core, path, golden_folder));
  for (const Failure& failure : unlisted) {
    print_error(failure.what());
    exit_code = more_serious(exit_code, failure.exit_code());
  }
  for (const UnreferencedGolden& golden : unreferenced) report(verdict_on(golden));
  print_text(counts_sentence(statuses, folders_failed) + "\n");
  return exit_code;
}

}  // namespace hyrax
