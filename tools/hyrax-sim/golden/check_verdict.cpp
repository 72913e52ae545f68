#include "tools/hyrax-sim/golden/check_verdict.h"

#include <chrono>
#include <exception>
#include <filesystem>
#include <map>
#include <optional>

#include "tools/files/path.h"
#include "tools/files/scenario_reader.h"
#include "tools/hyrax-sim/golden/golden_pair.h"
#include "tools/hyrax-sim/runs/paper_model.h"
#include "tools/hyrax-sim/runs/scenario_run.h"

namespace hyrax {
namespace {

namespace fs = std::filesystem;
using Status = CheckVerdict::Status;

std::vector<Expectation> broken_of(const Scenario& scenario, const RunSummary& summary) {
  std::vector<Expectation> broken;
  for (Expectation& expectation : judge_run(scenario, summary))
    if (!expectation.holds) broken.push_back(std::move(expectation));
  return broken;
}

// If only one part of a golden file exists, it was changed after it was blessed; a state hash in `expect`
// does not replace it.
bool has_state_hash_only(const Scenario& scenario, const std::optional<GoldenPlace>& place) {
  const bool has_part = place && (is_there(place->h5_path) || is_there(place->txt_path));
  return !has_part && scenario.expect && scenario.expect->state_hash;
}

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
  verdict.broken = broken_of(scenario, pair->summary);
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

struct FolderPair {
  fs::path scenarios;
  fs::path golden;
};

// Nothing if the folder is neither named `scenarios` nor below one.
std::optional<FolderPair> folders_of(const std::string& argument, const std::string& golden_folder) {
  if (!is_folder(argument)) return std::nullopt;
  const std::string any_scenario = (fs::path(argument) / "x.json").string();
  if (!golden_place(any_scenario, "")) return std::nullopt;
  return FolderPair{argument, fs::path(golden_place(any_scenario, golden_folder)->h5_path).parent_path()};
}

bool is_part_of_golden_file(const fs::directory_entry& entry) {
  const fs::path suffix = entry.path().extension();
  return (suffix == ".h5" || suffix == ".txt") && !is_folder(entry.path().string());
}

// By their path without suffix, so that both parts count once.
void add_unreferenced(const FolderPair& folders, std::map<std::string, CheckVerdict>& found) {
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folders.golden)) {
    if (!is_part_of_golden_file(entry)) continue;
    const fs::path stem = fs::path(entry.path()).replace_extension();
    fs::path scenario = folders.scenarios / stem.lexically_relative(folders.golden);
    scenario += ".json";
    if (is_there(scenario.string()) && !is_folder(scenario.string())) continue;
    CheckVerdict& verdict = found[stem.lexically_normal().string()];
    verdict.path = stem.generic_string();
    verdict.status = Status::unreferenced;
    verdict.exit_code = ExitCode::disagreed;
  }
}

}  // namespace

std::string_view name_of(Status status) {
  constexpr std::string_view kNames[] = {"agreed", "disagreed", "missing", "failed", "unreferenced"};
  return kNames[static_cast<std::size_t>(status)];
}

CheckVerdict check_scenario(const std::string& path, const CheckOptions& options) {
  CheckVerdict verdict;
  verdict.path = path;
  verdict.golden_folder = options.golden_folder;
  const auto start = std::chrono::steady_clock::now();
  try {
    if (path == "-")
      throw Failure(ExitCode::bad_input, "-: standard input has no golden file; name a scenario file");
    judge_into(load_scenario(path), options, verdict);
    if (verdict.status == Status::disagreed) verdict.exit_code = ExitCode::disagreed;
    if (verdict.status == Status::missing) verdict.exit_code = ExitCode::golden_missing;
  } catch (const Failure& failure) {
    fail(verdict, failure.exit_code(), failure.what());
  } catch (const std::exception& error) {  // Uncaught, it would terminate the program.
    fail(verdict, ExitCode::program_fault, path + ": internal error: " + error.what());
  }
  verdict.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return verdict;
}

std::vector<CheckVerdict> find_unreferenced(const std::vector<std::string>& arguments,
                                            const std::string& golden_folder) {
  std::map<std::string, CheckVerdict> found;
  for (const std::string& argument : arguments) {
    const auto folders = folders_of(argument, golden_folder);
    if (!folders || !is_folder(folders->golden.string())) continue;
    try {
      add_unreferenced(*folders, found);
    } catch (const fs::filesystem_error& error) {
      const std::string folder = folders->golden.generic_string();
      found[folder].path = folder;
      fail(found[folder], ExitCode::cannot_access, folder + ": cannot be read: " + error.code().message());
    }
  }
  std::vector<CheckVerdict> verdicts;
  for (auto& [path, verdict] : found) verdicts.push_back(std::move(verdict));
  return verdicts;
}

}  // namespace hyrax
