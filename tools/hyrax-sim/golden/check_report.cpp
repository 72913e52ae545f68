#include "tools/hyrax-sim/golden/check_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "tools/files/path.h"
#include "tools/files/printable.h"
#include "tools/hyrax-sim/command_line/shell_command.h"
#include "tools/hyrax-sim/golden/group_text.h"

namespace hyrax {
namespace {

using Status = CheckVerdict::Status;

// The names of the physics models, where they differ: each sentence once.
std::string physics_text(const CheckReport& report) {
  std::set<std::string> sentences;
  for (const CheckVerdict& verdict : report.verdicts())
    if (!verdict.comparison.agrees && !verdict.comparison.physics.empty())
      sentences.insert(verdict.comparison.physics);
  std::string text;
  for (const std::string& sentence : sentences) text += sentence + "\n";
  return text;
}

// How many of those that differ break their expectations as well.
std::string broken_text(const CheckReport& report) {
  const auto broken = std::ranges::count_if(report.verdicts(), [&](const CheckVerdict& verdict) {
    return report.group_of(verdict) != nullptr && !verdict.broken.empty();
  });
  return broken == 0 ? "" : fmt::format("  expect  does not hold in {} of them\n", broken);
}

// A line each: what is missing, failed or unreferenced, and expectations that do not hold.
void print_lines(const CheckReport& report) {
  for (const CheckVerdict& verdict : report.verdicts())
    if (verdict.status != Status::agreed && report.group_of(verdict) == nullptr)
      print_text("{}: {}: {}\n", printable(verdict.path), VerdictWord{name_of(verdict.status), false},
                 verdict_sentence(report, verdict));
}

// What bless accepts without --accept: rounding, and edits of the scenarios themselves.
std::string accept_option(const CheckReport& report) {
  DifferenceClass widest = DifferenceClass::rounding;
  for (const DifferenceGroup& group : report.groups())
    if (group.cause.operation != kScenarioCause) widest = std::max(widest, group.difference);
  return widest == DifferenceClass::rounding ? "" : fmt::format(" --accept {}", name_of(widest));
}

// The commands that show more of the worst scenario, and that accept all.
std::string commands_text(const CheckReport& report) {
  const DifferingScenario& worst = report.groups().front().scenarios.front();
  const CheckVerdict& verdict = report.verdict_on(worst);
  const bool is_alone = report.groups().size() == 1 && report.groups().front().scenarios.size() == 1;
  const std::vector<std::string> checked =
      report.arguments().empty() ? std::vector<std::string>{"scenarios"} : report.arguments();
  std::vector<std::string> verbose = {"check", "--verbose"};
  for (const std::string& argument : report.arguments()) verbose.push_back(as_argument(argument));
  if (!report.golden_folder().empty())
    verbose.insert(verbose.end(), {"--golden", as_argument(report.golden_folder())});
  std::vector<const CheckVerdict*> blessed;
  for (const CheckVerdict& each : report.verdicts())
    if (each.status != Status::unreferenced && (!is_alone || &each == &verdict)) blessed.push_back(&each);
  return fmt::format("  to see all      {}\n  to see more     {}; {}\n", program_command(verbose),
                     program_command({"run", as_argument(worst.path), "-o", "now.h5"}),
                     program_command({"diff", as_argument(verdict.golden->h5_path), "now.h5"})) +
         acceptance_text(is_alone ? std::vector{worst.path} : checked, accept_option(report), blessed);
}

void print_every(const CheckReport& report) {
  for (const CheckVerdict& verdict : report.verdicts())
    print_text("{}: {}\n{}", printable(verdict.path),
               VerdictWord{name_of(verdict.status), verdict.status == Status::agreed},
               verdict_details(verdict, true));
}

}  // namespace

CheckReport::CheckReport(std::vector<CheckVerdict> verdicts, std::vector<std::string> arguments,
                         std::string golden_folder)
    : verdicts_(std::move(verdicts)),
      arguments_(std::move(arguments)),
      golden_folder_(std::move(golden_folder)) {
  std::vector<DifferingScenario> differing;
  for (const CheckVerdict& verdict : verdicts_) {
    verdict_on_[&verdict.comparison] = &verdict;
    if (verdict.status == Status::disagreed && !verdict.comparison.agrees)
      differing.push_back({verdict.path, &verdict.comparison, verdict.runs.get()});
  }
  if (!differing.empty()) groups_ = group_by_cause(differing);
  for (const DifferenceGroup& group : groups_)
    for (const DifferingScenario& scenario : group.scenarios) group_of_[scenario.comparison] = &group;
}

std::int64_t CheckReport::count(Status status) const {
  return std::ranges::count(verdicts_, status, &CheckVerdict::status);
}

std::int64_t CheckReport::scenario_count() const {
  return static_cast<std::int64_t>(verdicts_.size()) - count(Status::unreferenced);
}

const DifferenceGroup* CheckReport::group_of(const CheckVerdict& verdict) const {
  const auto found = group_of_.find(&verdict.comparison);
  return found == group_of_.end() ? nullptr : found->second;
}

const CheckVerdict& CheckReport::verdict_on(const DifferingScenario& scenario) const {
  return *verdict_on_.at(scenario.comparison);
}

std::string counts_sentence(const CheckReport& report) {
  std::vector<CheckStatus> statuses;
  for (const CheckVerdict& verdict : report.verdicts()) statuses.push_back(verdict.status);
  return counts_sentence(statuses);
}

void print_check(const CheckReport& report, const Printing& printing) {
  if (printing.is_quiet()) {
    for (const CheckVerdict& verdict : report.verdicts())
      if (verdict.status == Status::failed) print_error(verdict.error);
    return print_text("{}\n", counts_sentence(report));
  }
  if (printing.is_verbose()) print_every(report);
  const GroupCounts counts{static_cast<std::size_t>(report.scenario_count()), report.groups().size()};
  for (const DifferenceGroup& group : report.groups()) print_group(group, counts);
  print_text("{}{}", broken_text(report), physics_text(report));
  print_lines(report);
  if (!report.groups().empty()) print_text("{}", commands_text(report));
  print_text("{}\n", counts_sentence(report));
}

}  // namespace hyrax
