// One verdict of `check` as text.
#include <fmt/format.h>

#include <algorithm>

#include "tools/files/golden_place.h"
#include "tools/files/unreferenced_golden.h"
#include "tools/hyrax-replay/judged_run.h"
#include "tools/hyrax-sim/command_line/shell_command.h"
#include "tools/hyrax-sim/golden/check_report.h"
#include "tools/hyrax-sim/golden/difference_text.h"
#include "tools/hyrax-sim/golden/group_text.h"

namespace hyrax {
namespace {

using Status = CheckVerdict::Status;

}  // namespace

std::string verdict_sentence(const CheckReport& report, const CheckVerdict& verdict) {
  const std::string broken = broken_sentence(verdict.broken);
  switch (verdict.status) {
    case Status::agreed:
      return "";
    case Status::failed:
      return verdict.error;
    case Status::unreferenced:
      return kUnreferencedSentence;
    case Status::missing:
      return fmt::format("{}; {}", missing_golden_sentence(verdict.golden),
                         !broken.empty()
                             ? broken
                             : "to create it: " + bless_command_for({verdict.path}, verdict.golden_folder));
    case Status::disagreed:
      break;
  }
  const DifferenceGroup* const group = report.group_of(verdict);
  if (group == nullptr) return broken.empty() ? "the state is not finite" : broken;
  return fmt::format("{}{}: {}{}", group->reproduced() == 0 ? "cause unknown: " : "", group->cause.detail,
                     scenario_consequence({verdict.path, &verdict.comparison, verdict.runs.get()}),
                     broken.empty() ? "" : "; " + broken);
}

std::string verdict_details(const CheckVerdict& verdict, bool lists_all) {
  if (verdict.status == Status::failed) return "  " + verdict.error + "\n";
  if (verdict.status == Status::unreferenced) return fmt::format("  {}\n", kUnreferencedSentence);
  if (verdict.status == Status::agreed) return "";
  std::string text;
  for (const Expectation& broken : verdict.broken)
    text += fmt::format("  expect     {}\n", expectation_text(broken));
  const std::string bless = bless_command_for({verdict.path}, verdict.golden_folder);
  if (verdict.status == Status::missing)
    return text + fmt::format("  {}\n  to create it: {}\n", missing_golden_sentence(verdict.golden), bless);
  if (verdict.comparison.agrees) return text;
  return text + difference_text(verdict.comparison, lists_all) +
         fmt::format("  to see more     {}; {}\n",
                     program_command({"run", as_argument(verdict.path), "-o", "now.h5"}),
                     program_command({"diff", as_argument(verdict.golden->h5_path), "now.h5"})) +
         acceptance_text(bless, {&verdict});
}

std::string acceptance_text(const std::string& bless, const std::vector<const CheckVerdict*>& verdicts) {
  const auto is_hash = [](const Expectation& broken) { return broken.rule == "state_hash"; };
  const bool updates_hash = std::ranges::any_of(
      verdicts, [&](const CheckVerdict* verdict) { return std::ranges::any_of(verdict->broken, is_hash); });
  const auto edits = std::ranges::count_if(
      verdicts, [&](const CheckVerdict* verdict) { return !std::ranges::all_of(verdict->broken, is_hash); });
  const auto is_damaged = [](const CheckVerdict* verdict) {
    return verdict->runs && !verdict->runs->is_golden_as_blessed;
  };
  const auto first_damaged = std::ranges::find_if(verdicts, is_damaged);
  const auto others = std::ranges::count_if(verdicts, is_damaged) - 1;
  return (first_damaged == verdicts.end()
              ? ""
              : fmt::format("  to restore it   take {}{} from version control\n",
                            (*first_damaged)->golden->h5_path,
                            others == 0 ? "" : fmt::format(" and {} more", others))) +
         (edits == 0 ? ""
                     : fmt::format(
                           "  to edit first   expect of {} scenario{}: bless refuses a run for which it does "
                           "not hold\n",
                           edits, edits == 1 ? "" : "s")) +
         fmt::format("  to accept it    {}{}\n", bless, updates_hash ? " --update-hash" : "");
}

}  // namespace hyrax
