// One verdict of `check` as text.
#include <fmt/format.h>

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
  switch (verdict.status) {
    case Status::agreed:
      return "";
    case Status::failed:
      return verdict.error;
    case Status::unreferenced:
      return kUnreferencedSentence;
    case Status::missing:
      return fmt::format("{}; to create it: {}", missing_golden_sentence(verdict.golden),
                         bless_command_for({verdict.path}, verdict.golden_folder));
    case Status::disagreed:
      break;
  }
  const DifferenceGroup* const group = report.group_of(verdict);
  const std::string broken = broken_sentence(verdict.broken);
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
         fmt::format(
             "  to see more     {}; {}\n"
             "  to accept it    {}\n",
             program_command({"run", as_argument(verdict.path), "-o", "now.h5"}),
             program_command({"diff", as_argument(verdict.golden->h5_path), "now.h5"}), bless);
}

}  // namespace hyrax
