#include "tools/app/bless/bless_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "sim/cause/cause.h"
#include "sim/trajectory/physics_model.h"
#include "tools/app/check/check_verdict.h"
#include "tools/app/expect/judged_run.h"
#include "tools/files/scenario_list.h"
#include "tools/files/scenario_reader.h"
#include "tools/files/summary_text.h"
#include "tools/files/text_file.h"

namespace hyrax {
namespace {

namespace fs = std::filesystem;

// A damaged one is replaced.
std::optional<AcceptedCore> accepted_before(const std::string& golden_folder) try {
  return read_accepted_core(golden_folder);
} catch (const Failure&) {
  return std::nullopt;
}

std::string canonical_path(const std::string& path) {
  std::error_code unknown;
  return fs::weakly_canonical(path, unknown).string();
}

// Those that are blessed now, by their canonical paths.
using BlessingsByPath = std::map<std::string, const Blessing*>;

// What became of the scenarios that are not blessed now.
struct LibraryCheck {
  std::vector<std::string> disagreeing;
  std::string not_repeated;     // One that agrees, but gives other bits when it is played again.
  std::set<std::string> cores;  // That golden files name which stay as they are.
  std::size_t checked = 0;
};

LibraryCheck check_library(const Core& core, const Library& library, const std::string& golden_option,
                           const BlessingsByPath& blessed) {
  LibraryCheck result;
  for (const std::string& path : list_scenarios({library.scenarios_folder})) {
    ++result.checked;
    if (const auto found = blessed.find(canonical_path(path)); found != blessed.end()) {
      const Blessing& blessing = *found->second;
      if (blessing.status == Blessing::Status::unchanged)
        result.cores.insert(summary_core(read_text_file(blessing.golden->txt_path)));
      continue;
    }
    const CheckVerdict verdict = check_scenario(core, path, {.golden_folder = golden_option});
    if (verdict.status != CheckStatus::agreed)
      result.disagreeing.push_back(path);
    else if (play(core, load_scenario(path)).state_hash != verdict.summary.state_hash)
      result.not_repeated = path;
    else if (verdict.has_golden)
      result.cores.insert(summary_core(read_text_file(verdict.golden->txt_path)));
  }
  return result;
}

std::optional<CoreAcceptance> plan(const Core& core, const Library& library, const BlessingsByPath& blessed,
                                   const BlessOptions& options) {
  AcceptedCore accepted = program_core(core);
  const std::optional<AcceptedCore> before = accepted_before(library.golden_folder);
  if (before && before->header == accepted.header && before->files == accepted.files &&
      before->step == accepted.step && before->model == accepted.model)
    return std::nullopt;
  LibraryCheck check = check_library(core, library, options.golden_folder, blessed);
  accepted.reason = options.reason;
  check.cores.erase(accepted.name());
  check.cores.erase("");
  accepted.agreeing_cores.assign(check.cores.begin(), check.cores.end());
  CoreAcceptance acceptance{library.golden_folder, std::move(accepted), "", false, {}};
  if (!check.disagreeing.empty()) {
    acceptance.why_not = fmt::format("{} of {} scenarios do not agree, the first is {}",
                                     check.disagreeing.size(), check.checked, check.disagreeing.front());
    return acceptance;
  }
  if (!check.not_repeated.empty()) {
    acceptance.why_not = fmt::format("{}: {}", check.not_repeated, kNotRepeated);
    return acceptance;
  }
  if (before && !is_same_model(before->model, core.name) && options.accepted < DifferenceClass::shape) {
    acceptance.is_refused = true;
    acceptance.why_not = fmt::format(
        "the accepted core is of another class (found {}); --accept shape replaces it", before->model);
    return acceptance;
  }
  for (const char* const name : {"/physics.h", "/step.txt", "/accepted.txt", "/files/of_project"})
    require_writable(accepted_core_folder(library.golden_folder) + name);
  CoreCheck differences(core, library.golden_folder, {});
  differences.judge_differences({library.scenarios_folder}, 0);
  acceptance.differences = differences.verdict();
  return acceptance;
}

}  // namespace

std::vector<CoreAcceptance> plan_core_acceptances(const Core& core, const std::vector<std::string>& arguments,
                                                  const std::vector<Blessing>& blessings,
                                                  const BlessOptions& options) {
  BlessingsByPath blessed;
  for (const Blessing& blessing : blessings) blessed.emplace(canonical_path(blessing.path), &blessing);
  std::vector<CoreAcceptance> acceptances;
  for (const Library& library : libraries_of(arguments, options.golden_folder))
    if (auto acceptance = plan(core, library, blessed, options))
      acceptances.push_back(std::move(*acceptance));
  return acceptances;
}

void write_cores(std::vector<CoreAcceptance>& cores, const std::vector<Blessing>& blessings) {
  const bool has_failed = std::ranges::any_of(blessings, &Blessing::has_failed);
  for (CoreAcceptance& acceptance : cores) {
    if (!acceptance.why_not.empty()) continue;
    if (has_failed)
      acceptance.why_not = "not every golden file could be written";
    else
      write_accepted_core(acceptance.golden_folder, acceptance.core);
  }
}

std::string acceptances_text(const std::vector<CoreAcceptance>& cores, bool is_written) {
  std::string text;
  for (const CoreAcceptance& acceptance : cores) {
    const std::string folder = accepted_core_folder(acceptance.golden_folder);
    if (!acceptance.why_not.empty()) {
      text += fmt::format("core: not accepted in {}: {}\n", folder, acceptance.why_not);
      continue;
    }
    if (!acceptance.differences.unnoticed.empty()) text += core_text(acceptance.differences);
    text += fmt::format("core: {} in {}\n", is_written ? "accepted" : "would be accepted", folder);
  }
  return text;
}

}  // namespace hyrax
