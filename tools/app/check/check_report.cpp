#include "tools/app/check/check_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "tools/app/command_line/shell_command.h"
#include "tools/files/path.h"
#include "tools/files/printable.h"

namespace hyrax {
namespace {

// The names of the physics models, where they differ: each sentence once.
std::string physics_text(const CheckReport& report) {
  std::set<std::string> sentences;
  for (const CheckVerdict& verdict : report.verdicts)
    if (!verdict.comparison.agrees && !verdict.comparison.physics.empty())
      sentences.insert(verdict.comparison.physics);
  std::string text;
  for (const std::string& sentence : sentences) text += sentence + "\n";
  return text;
}

// How many of those that differ break their expectations as well.
std::string broken_text(const CheckReport& report) {
  const auto broken = std::ranges::count_if(report.verdicts, [&](const CheckVerdict& verdict) {
    return verdict.group != nullptr && !verdict.broken.empty();
  });
  return broken == 0 ? "" : fmt::format("  expect  does not hold in {} of them\n", broken);
}

// "a, b, c and 37 more".
std::string names_text(const std::vector<const CheckVerdict*>& verdicts) {
  constexpr std::size_t kNamed = 3;
  std::string text;
  for (std::size_t index = 0; index < std::min(verdicts.size(), kNamed); ++index)
    text += (index == 0 ? "" : ", ") + printable(verdicts[index]->path);
  return verdicts.size() <= kNamed ? text : text + fmt::format(" and {} more", verdicts.size() - kNamed);
}

void print_line(const CheckVerdict& verdict) {
  print_text("{}: {}: {}\n", printable(verdict.path), VerdictWord{name_of(verdict.status), false},
             verdict_sentence(verdict));
}

// With how to accept them all, unless others keep bless from it.
void print_missing(const CheckReport& report, const std::vector<const CheckVerdict*>& missing) {
  if (missing.size() == 1) return print_line(*missing.front());
  const std::string& folder = report.golden_folder;
  print_text("{} scenarios: {}: {}: {}\n", missing.size(), VerdictWord{name_of(CheckStatus::missing), false},
             folder.empty() || is_folder(folder) ? "no golden file" : "no folder " + printable(folder),
             names_text(missing));
  std::vector<std::string> paths = report.arguments;
  if (std::ssize(missing) + report.count(CheckStatus::agreed) != report.scenario_count()) {
    paths.clear();
    for (const CheckVerdict* const verdict : missing) paths.push_back(verdict->path);
  } else if (paths.empty()) {
    paths = {"scenarios"};
  }
  print_text("  to create them  {}\n", bless_command_for(paths, report.golden_folder));
}

// A line for each kind: what is missing, failed or unreferenced, and expectations that do not hold.
void print_lines(const CheckReport& report) {
  std::vector<const CheckVerdict*> missing;
  std::vector<const CheckVerdict*> unreferenced;
  for (const CheckVerdict& verdict : report.verdicts) {
    if (verdict.status == CheckStatus::agreed || verdict.group != nullptr) continue;
    const bool is_renamed = verdict.renamed != nullptr;
    if (verdict.status == CheckStatus::unreferenced && !is_renamed)
      unreferenced.push_back(&verdict);
    else if (verdict.status == CheckStatus::missing && !is_renamed && verdict.broken.empty() &&
             verdict.non_finite.empty())
      missing.push_back(&verdict);
    else if (verdict.status != CheckStatus::unreferenced)
      print_line(verdict);
  }
  if (!missing.empty()) print_missing(report, missing);
  if (unreferenced.size() == 1) print_line(*unreferenced.front());
  if (unreferenced.size() > 1)
    print_text("{} golden files: {}: no scenario: {}\n", unreferenced.size(),
               VerdictWord{name_of(CheckStatus::unreferenced), false}, names_text(unreferenced));
}

// A line for each status but `agreed`; why one failed is on standard error.
void print_names(const CheckReport& report) {
  for (const CheckStatus status : {CheckStatus::disagreed, CheckStatus::missing, CheckStatus::unreferenced}) {
    std::vector<const CheckVerdict*> verdicts;
    for (const CheckVerdict& verdict : report.verdicts)
      if (verdict.status == status) verdicts.push_back(&verdict);
    if (!verdicts.empty()) print_text("{}: {}\n", VerdictWord{name_of(status), false}, names_text(verdicts));
  }
}

// The commands that show more of the worst scenario, and that accept all.
std::string commands_text(const CheckReport& report) {
  const PairVerdict& worst = *report.groups.front().scenarios.front();
  const bool is_alone = report.groups.size() == 1 && report.groups.front().scenarios.size() == 1;
  std::vector<std::string> paths = report.arguments;
  if (is_alone)
    paths = {worst.path};
  else if (paths.empty())
    paths = {"scenarios"};
  std::vector<std::string> verbose = {"check", "--verbose"};
  for (const std::string& argument : report.arguments) verbose.push_back(as_argument(argument));
  if (!report.golden_folder.empty())
    verbose.insert(verbose.end(), {"--golden", as_argument(report.golden_folder)});
  std::vector<const CheckVerdict*> blessed;
  for (const CheckVerdict& each : report.verdicts)
    if (each.status != CheckStatus::unreferenced && (!is_alone || &each == &worst)) blessed.push_back(&each);
  const std::string text =
      fmt::format("  to see all      {}\n  to see more     {}\n", program_command(verbose),
                  diff_commands(worst.path, worst.golden->h5_path));
  // Its results are others the next time.
  if (std::ranges::any_of(report.groups, [](const auto& each) { return each.cause.detail == kNotRepeated; }))
    return text;
  return text + acceptance_text(paths, blessed);
}

}  // namespace

void explain(CheckReport& report) {
  std::vector<CheckVerdict>& verdicts = report.verdicts;
  std::vector<const PairVerdict*> differing;
  for (const CheckVerdict& verdict : verdicts) {
    if (is_folder(verdict.golden_folder))
      report.cores.of(verdict.golden_folder).take_paths(verdict.paths_taken);
    if (verdict.status == CheckStatus::disagreed && !verdict.comparison.agrees) differing.push_back(&verdict);
  }
  for (CheckVerdict& missing : verdicts)
    for (CheckVerdict& golden : verdicts)
      if (missing.status == CheckStatus::missing && golden.status == CheckStatus::unreferenced &&
          !golden.state_hash.empty() && missing.state_hash == golden.state_hash &&
          missing.renamed == nullptr && golden.renamed == nullptr) {
        missing.renamed = &golden;
        golden.renamed = &missing;
      }
  if (!differing.empty()) report.groups = group_by_cause(differing, report.cores);
  for (const DifferenceGroup& group : report.groups)
    for (const PairVerdict* const scenario : group.scenarios)
      verdicts[static_cast<std::size_t>(&verdict_on(*scenario) - verdicts.data())].group = &group;
}

std::int64_t CheckReport::count(CheckStatus status) const {
  return std::ranges::count(verdicts, status, &CheckVerdict::status);
}

std::int64_t CheckReport::scenario_count() const {
  return std::ranges::count_if(verdicts, &CheckVerdict::is_scenario);
}

std::string counts_sentence(const CheckReport& report) {
  std::vector<CheckStatus> statuses;
  std::int64_t folders_failed = 0;
  for (const CheckVerdict& verdict : report.verdicts)
    if (!verdict.is_scenario && verdict.status == CheckStatus::failed)
      ++folders_failed;
    else
      statuses.push_back(verdict.status);
  return counts_sentence(statuses, folders_failed);
}

std::vector<OtherFailure> other_failures(const CheckReport& report) {
  std::vector<OtherFailure> failed;
  for (const Failure& failure : report.unlisted)
    failed.push_back({"folder", "", failure.what(), failure.exit_code()});
  for (const CoreVerdict* const core : report.cores.verdicts()) {
    if (core->exit_code == ExitCode::agreed) continue;
    std::string text = core_text(*core, report.cores.verdicts().size() == 1, report.groups.empty());
    text.pop_back();
    failed.push_back({"core", accepted_core_folder(core->golden_folder) + "/accepted.txt", std::move(text),
                      core->exit_code});
  }
  return failed;
}

void print_check(const CheckReport& report, const Printing& printing) {
  if (printing.is_quiet()) {
    for (const OtherFailure& other : other_failures(report))  // Those of folders are on standard error.
      if (!other.file.empty()) print_text("{}\n", other.text.substr(0, other.text.find('\n')));
    for (const CheckVerdict& verdict : report.verdicts)
      if (verdict.status == CheckStatus::failed) print_error(verdict.error);
    print_names(report);
    return print_text("{}\n", counts_sentence(report));
  }
  if (printing.is_verbose())
    for (const CheckVerdict& verdict : report.verdicts)
      print_text("{}: {}\n{}", printable(verdict.path),
                 VerdictWord{name_of(verdict.status), verdict.status == CheckStatus::agreed},
                 verdict_details(verdict, true));
  const auto checked = static_cast<std::size_t>(report.scenario_count());
  print_groups(report.groups, report.cores.verdicts(), checked);
  print_text("{}{}", broken_text(report), physics_text(report));
  print_lines(report);
  if (!report.groups.empty()) print_text("{}", commands_text(report));
  print_text("{}\n", counts_sentence(report));
}

}  // namespace hyrax
