#include <fmt/format.h>

#include <filesystem>

#include "tools/files/presence.h"
#include "tools/files/scenario_list.h"
#include "tools/files/scenario_reader.h"
#include "tools/files/text_file.h"
#include "tools/hyrax-sim/commands.h"
#include "tools/hyrax-sim/difference_text.h"
#include "tools/hyrax-sim/drift_run.h"
#include "tools/hyrax-sim/golden_check.h"
#include "tools/hyrax-sim/margin_text.h"
#include "tools/hyrax-sim/print.h"
#include "tools/hyrax-sim/run_expectations.h"
#include "tools/hyrax-sim/run_report.h"
#include "tools/store/golden_digest.h"
#include "tools/store/golden_file.h"
#include "tools/store/golden_place.h"
#include "tools/store/golden_seal.h"
#include "tools/store/output_guard.h"

namespace hyrax {
namespace {

namespace fs = std::filesystem;

struct BlessRequest {
  std::vector<std::string> files;
  std::string reason;
  std::string golden_folder;
};

GoldenPlace place_of(const std::string& path, const std::string& golden_folder) {
  const auto place = golden_place(path, golden_folder);
  if (!place)
    throw Failure(
        ExitCode::bad_input,
        path + ": is in no folder named scenarios; say with --golden DIR where its golden file goes");
  return *place;
}

// Says what the blessing changes; returns whether it changes anything.
bool show_changes(const std::string& path, const GoldenPlace& place, const Scenario& scenario) {
  if (!has_golden_file(place) || !is_there(place.txt_path)) {
    print_text("{}: new golden file\n", path);
    return true;
  }
  try {
    const StoredRun kept = read_golden(place.h5_path);
    const Comparison comparison = compare_with(kept, scenario).comparison;
    const bool is_digest_true = read_digest_hash(place.txt_path) == kept.state_hash;
    if (comparison.agrees && is_digest_true) return false;
    print_text("{}: changes {}\n{}", path, comparison.agrees ? place.txt_path : place.h5_path,
               difference_text(comparison));
  } catch (const Failure& failure) {
    print_text("{}: replaces a golden file that cannot be read ({})\n", path, failure.what());
  }
  return true;
}

void refuse_unexpected(const std::string& path, const FreshRun& fresh) {
  std::string broken;
  for (const Expectation& expectation : judge_run(fresh.run.scenario, fresh.summary))
    if (!expectation.holds) broken += "; " + expectation_text(expectation);
  if (fresh.summary.non_finite_step)
    broken += fmt::format("; the state is not finite from step {}", *fresh.summary.non_finite_step);
  if (!broken.empty())
    throw Failure(ExitCode::disagreed, path + ": not blessed: its expectations do not hold" + broken);
}

// @param h5_file the golden file, or the part that will become it.
std::string digest_of(const FreshRun& fresh, const std::string& h5_file, const std::string& reason) {
  const Margin margin = margin_of(rows_of(fresh.run.scenario, fresh.summary));
  return golden_digest_text(fresh.run, fresh.summary, reason,
                            margin_text(margin) + (is_knife_edge(margin) ? " (a knife edge)" : "")) +
         seal_line({contents_hash(fresh.run), file_hash(h5_file)});
}

void write(const GoldenPlace& place, const FreshRun& fresh, const std::string& reason) {
  std::error_code error;
  fs::create_directories(fs::path(place.h5_path).parent_path(), error);
  AtomicFile rows(place.h5_path);
  AtomicFile digest(place.txt_path);
  write_golden(rows, place.h5_path, fresh.run);
  digest.write(digest_of(fresh, rows.part_path(), reason));
  // The rows come last: until they stand there, `check` compares with the old ones and says so.
  digest.commit();
  rows.commit();
}

// The golden file agrees; its digest may be of an older form.
void renew_digest(const std::string& path, const GoldenPlace& place, const FreshRun& fresh,
                  const std::string& reason) {
  const std::string kept = read_text_file(place.txt_path);
  if (kept == digest_of(fresh, place.h5_path, digest_reason(kept))) {
    print_text("{}: agrees with {} already; nothing written\n", path, place.h5_path);
    return;
  }
  refuse_unexpected(path, fresh);
  write_text_file(place.txt_path, digest_of(fresh, place.h5_path, reason));
  print_text("{}: agrees with {} already; its digest, {}, is written anew\n", path, place.h5_path,
             place.txt_path);
}

void bless_one(const std::string& path, const BlessRequest& request) {
  const Scenario scenario = load_scenario(path);
  const GoldenPlace place = place_of(path, request.golden_folder);
  const bool is_changed = show_changes(path, place, scenario);
  const FreshRun fresh = play_for_golden(scenario);
  if (!is_changed && !golden_words_fault(place.h5_path))
    return renew_digest(path, place, fresh, request.reason);
  refuse_unexpected(path, fresh);
  write(place, fresh, request.reason);
  print_text("{}: blessed, {}\n", path, place.h5_path);
}

ExitCode bless(const BlessRequest& request) {
  if (request.reason.find_first_not_of(" \t\n") == std::string::npos)
    throw Failure(
        ExitCode::bad_input,
        "hyrax-sim bless: --reason must say why the golden files change, as in --reason 'wider window'");
  const std::vector<std::string> paths = list_scenarios(request.files);
  OutputGuard guard(paths);
  for (const std::string& path : paths)
    if (const auto place = golden_place(path, request.golden_folder))
      for (const std::string& output : {place->h5_path, place->txt_path})
        guard.admit_golden("hyrax-sim bless: golden file of " + path, output);
  ExitCode exit_code = ExitCode::agreed;
  for (const std::string& path : paths) {
    try {
      bless_one(path, request);
    } catch (const Failure& failure) {
      print_error(failure.what());
      exit_code = more_serious(exit_code, failure.exit_code());
    }
  }
  return exit_code;
}

}  // namespace

Command bless_command() {
  return {.name = "bless",
          .summary = "make runs the new golden files, with a reason",
          .example = "hyrax-sim bless scenarios/flings/first-fling.json --reason 'a longer throw'",
          .is_common = true,
          .declare = [](Options& options) {
            const auto request = std::make_shared<BlessRequest>();
            options.files(request->files, {"SCENARIO", "", "scenario files, or folders of them"}, 1, -1);
            options.text(request->reason, {"--reason", "TEXT", "why; stands in the digest (required)"});
            options.text(request->golden_folder,
                         {"--golden", "DIR", "golden files; the `golden` beside `scenarios` if left out"});
            return [request] { return bless(*request); };
          }};
}

}  // namespace hyrax
