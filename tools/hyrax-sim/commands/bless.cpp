#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <map>

#include <unistd.h>

#include "tools/files/json.h"
#include "tools/files/path.h"
#include "tools/files/printable.h"
#include "tools/files/scenario_list.h"
#include "tools/files/scenario_reader.h"
#include "tools/files/text_file.h"
#include "tools/hyrax-sim/command_line/options.h"
#include "tools/hyrax-sim/golden/difference_text.h"
#include "tools/hyrax-sim/golden/golden_pair.h"
#include "tools/hyrax-sim/runs/scenario_run.h"
#include "tools/store/golden_file.h"
#include "tools/store/golden_summary.h"
#include "tools/store/output_guard.h"

namespace hyrax {
namespace {

namespace fs = std::filesystem;

struct BlessRequest {
  std::vector<std::string> files;
  std::string reason;
  std::string golden_folder;
  Printing printing;
};

// The plan for one scenario. All are planned before the first is written.
struct Blessing {
  enum class Status { fresh, changed, unchanged, failed };
  std::string path;
  GoldenPlace place;
  Status status = Status::unchanged;
  bool keeps_h5 = false;   // Only the summary is written.
  Comparison comparison;   // With the present golden file.
  std::string unreadable;  // Why that one cannot be read; else empty.
  std::string error;       // Of a failed one.
  ExitCode exit_code = ExitCode::agreed;
};

using Status = Blessing::Status;

std::string_view name_of(Status status) {
  constexpr std::string_view kNames[] = {"new", "changed", "unchanged", "failed"};
  return kNames[static_cast<std::size_t>(status)];
}

GoldenPlace place_of(const std::string& path, const std::string& golden_folder) {
  if (path == "-")
    throw Failure(ExitCode::bad_input, "-: standard input has no golden file; name a scenario file");
  const auto place = golden_place(path, golden_folder);
  if (!place)
    throw Failure(
        ExitCode::bad_input,
        path + ": no folder `scenarios` above it; name the folder of its golden file with --golden DIR");
  return *place;
}

// As far as possible without writing.
void require_writable(const GoldenPlace& place) {
  for (const std::string& path : {place.h5_path, place.txt_path}) {
    fs::path folder = fs::absolute(path).parent_path();
    while (!is_there(folder.string()) && folder.has_relative_path()) folder = folder.parent_path();
    if (!is_folder(folder.string())) fail_to_write(path, ENOTDIR);
    if (access(folder.c_str(), W_OK | X_OK) != 0) fail_to_write(path, errno);
  }
}

void require_usable(const GoldenPlace& place, const OutputGuard& guard) {
  for (const std::string& path : {place.h5_path, place.txt_path}) {
    if (is_folder(path)) fail_to_write(path, EISDIR);
    guard.admit_golden("hyrax-sim bless: --golden", path);
  }
}

void require_expected(const std::string& path, const Scenario& scenario, const RunSummary& summary) {
  std::string broken;
  for (const Expectation& expectation : judge_run(scenario, summary))
    if (!expectation.holds) broken += "; " + expectation_text(expectation);
  if (summary.non_finite_step)
    broken += fmt::format("; the state is not finite from step {}", *summary.non_finite_step);
  if (!broken.empty())
    throw Failure(ExitCode::disagreed, path + ": not blessed: its expectations do not hold" + broken);
}

// Sets what has to be blessed; returns the summary of the run.
RunSummary compare(const Scenario& scenario, Blessing& blessing) {
  const auto replace_unreadable = [&](const std::string& why) {
    blessing.status = Status::changed;
    blessing.unreadable = why;
    blessing.comparison.agrees = false;
    blessing.comparison.difference = DifferenceClass::shape;
    return play(scenario);
  };
  if (!has_golden_file(blessing.place)) {
    const auto& [h5_path, txt_path] = blessing.place;
    if (is_there(h5_path)) return replace_unreadable(txt_path + " is missing");
    if (is_there(txt_path)) return replace_unreadable(h5_path + " is missing");
    blessing.status = Status::fresh;
    return play(scenario);
  }
  try {
    PairComparison pair = *compare_with_pair(scenario, blessing.place, true);
    blessing.comparison = std::move(pair.comparison);
    blessing.keeps_h5 = !pair.is_current && is_h5_current(scenario, blessing.place);
    blessing.status = pair.is_current ? Status::unchanged : Status::changed;
    return pair.summary;
  } catch (const Failure& failure) {
    if (failure.exit_code() != ExitCode::bad_input) throw;
    return replace_unreadable(failure.what());
  }
}

void plan(Blessing& blessing, const BlessRequest& request, const OutputGuard& guard) {
  const Scenario scenario = load_scenario(blessing.path);
  blessing.place = place_of(blessing.path, request.golden_folder);
  require_usable(blessing.place, guard);
  const RunSummary summary = compare(scenario, blessing);
  if (blessing.status == Status::unchanged) return;
  require_writable(blessing.place);
  require_expected(blessing.path, scenario, summary);
}

void write(const Blessing& blessing, const std::string& reason) {
  const auto& [h5_path, txt_path] = blessing.place;
  const FreshRun fresh = play_for_golden(load_scenario(blessing.path));
  if (blessing.keeps_h5) return write_text_file(txt_path, summary_of(fresh, reason, file_checksum(h5_path)));
  std::error_code error;
  fs::create_directories(fs::path(h5_path).parent_path(), error);
  AtomicFile rows(h5_path);
  AtomicFile summary(txt_path);
  write_golden(rows, h5_path, fresh.run);
  summary.write(summary_of(fresh, reason, file_checksum(rows.part_path())));
  // The rows come last: until they are there, `check` compares with the old ones and reports it.
  summary.commit();
  rows.commit();
}

// A failure of one scenario does not end the others.
template <class Step>
void attempt(Blessing& blessing, const Step& step) {
  if (blessing.status == Status::failed) return;
  try {
    return step();
  } catch (const Failure& failure) {
    blessing.error = failure.what();
    blessing.exit_code = failure.exit_code();
  } catch (const std::exception& error) {
    blessing.error = blessing.path + ": internal error: " + error.what();
    blessing.exit_code = ExitCode::program_fault;
  }
  blessing.status = Status::failed;
  print_error(blessing.error);
}

// Refuses scenarios that share a golden file: each would overwrite the other's. A scenario that is given
// twice is blessed once.
std::vector<Blessing> without_shared_places(std::vector<Blessing> blessings) {
  std::map<std::string, std::string> owners;
  std::vector<Blessing> kept;
  for (Blessing& blessing : blessings) {
    std::error_code unknown;
    const std::string place = fs::weakly_canonical(blessing.place.h5_path, unknown).string();
    const auto [entry, is_first] = owners.emplace(place, blessing.path);
    const std::string& owner = entry->second;
    if (!is_first && blessing.status != Status::failed) {
      if (fs::equivalent(owner, blessing.path, unknown)) continue;
      attempt(blessing, [&] {
        throw Failure(ExitCode::bad_input, blessing.path + ": has the same golden file as " + owner + " (" +
                                               blessing.place.h5_path +
                                               "); bless them with different --golden DIR");
      });
    }
    kept.push_back(std::move(blessing));
  }
  return kept;
}

void print_plan(const Blessing& blessing, const Printing& printing) {
  const std::string path = printable(blessing.path);
  const std::string h5_path = printable(blessing.place.h5_path);
  if (blessing.status == Status::unchanged)
    print_text("{}: {} with {} already; nothing written\n", path, VerdictWord{"agrees", true}, h5_path);
  if (printing.is_quiet()) return;
  if (blessing.status == Status::fresh) print_text("{}: new golden file\n", path);
  if (blessing.status != Status::changed) return;
  if (!blessing.unreadable.empty())
    return print_text("{}: replaces a golden file that cannot be read ({})\n", path, blessing.unreadable);
  print_text("{}: changes {}\n{}", path, blessing.keeps_h5 ? printable(blessing.place.txt_path) : h5_path,
             difference_text(blessing.comparison, printing.is_verbose()));
}

void print_done(const Blessing& blessing) {
  if (blessing.status == Status::failed || blessing.status == Status::unchanged) return;
  const std::string path = printable(blessing.path);
  if (!blessing.keeps_h5)
    return print_text("{}: {}, {}\n", path, VerdictWord{"blessed", true}, printable(blessing.place.h5_path));
  print_text("{}: agrees with {} already; its summary, {}, is written again\n", path,
             printable(blessing.place.h5_path), printable(blessing.place.txt_path));
}

// null for a scenario that cannot be read.
Json path_json(const std::string& path) { return path.empty() ? Json() : Json(path); }

Json result_json(const Blessing& blessing) {
  const auto& difference = blessing.comparison.difference;
  Json::Object entry{{"scenario", blessing.path},
                     {"status", name_of(blessing.status)},
                     {"class", difference ? Json(name_of(*difference)) : Json()},
                     {"first_divergence", divergence_json(blessing.comparison.first)},
                     {"golden_file", path_json(blessing.place.h5_path)},
                     {"summary", path_json(blessing.place.txt_path)}};
  if (!blessing.error.empty()) entry.emplace_back("error", blessing.error);
  return entry;
}

Json bless_json(const std::vector<Blessing>& blessings, bool is_written) {
  Json::Object document;
  for (const Status status : {Status::fresh, Status::changed, Status::unchanged, Status::failed})
    document.emplace_back(name_of(status), std::ranges::count(blessings, status, &Blessing::status));
  document.emplace_back("written", is_written);
  Json::Array results;
  for (const Blessing& blessing : blessings) results.emplace_back(result_json(blessing));
  document.emplace_back("results", std::move(results));
  return document;
}

std::vector<Blessing> plan_all(const BlessRequest& request) {
  const std::vector<std::string> paths = list_scenarios(request.files);
  const OutputGuard guard(paths);
  std::vector<Blessing> blessings;
  for (const std::string& path : paths) {
    Blessing& blessing = blessings.emplace_back();
    blessing.path = path;
    attempt(blessing, [&] { plan(blessing, request, guard); });
  }
  return without_shared_places(std::move(blessings));
}

bool has_failed(const Blessing& blessing) { return blessing.status == Status::failed; }

// All checks come before the first write: if one fails, no golden file is changed.
ExitCode bless(const BlessRequest& request) {
  if (request.reason.find_first_not_of(" \t\n") == std::string::npos)
    throw Failure(
        ExitCode::bad_input,
        "hyrax-sim bless: --reason must say why the golden files change, as in --reason 'wider window'");
  std::vector<Blessing> blessings = plan_all(request);
  const auto failed = std::ranges::count_if(blessings, has_failed);
  for (Blessing& blessing : blessings) {
    if (!request.printing.is_json) print_plan(blessing, request.printing);
    if (failed > 0 || blessing.status == Status::unchanged) continue;
    attempt(blessing, [&] { write(blessing, request.reason); });
    if (!request.printing.is_json) print_done(blessing);
  }
  if (failed > 0)
    print_error(
        fmt::format("hyrax-sim bless: nothing written: {} of {} scenarios failed", failed, blessings.size()));
  if (request.printing.is_json)
    print_text("{}\n", to_text(bless_json(blessings, failed == 0), {.depth_indented = 2}));
  ExitCode exit_code = ExitCode::agreed;
  for (const Blessing& blessing : blessings) exit_code = more_serious(exit_code, blessing.exit_code);
  return exit_code;
}

}  // namespace

Command bless_command() {
  return {.name = "bless",
          .summary = "accept current results as the new golden files, with a reason",
          .example = "hyrax-sim bless scenarios/flings/first-fling.json --reason 'a longer throw'",
          .is_common = true,
          .declare = [](Options& options) {
            const auto request = std::make_shared<BlessRequest>();
            options.files(request->files, {"SCENARIO", "", "scenario files, or folders of them"}, 1, -1);
            options.text(request->reason,
                         {"--reason", "TEXT", "why they change; recorded in the summary (required)"});
            options.text(
                request->golden_folder,
                {"--golden", "DIR", "folder of golden files (default: the `golden` beside `scenarios`)"});
            options.printing(request->printing, "print all contacts that moved");
            return [request] { return bless(*request); };
          }};
}

}  // namespace hyrax
