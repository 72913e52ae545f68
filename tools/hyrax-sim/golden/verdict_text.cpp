// One verdict of `check` as text.
#include <fmt/format.h>

#include "tools/files/path.h"
#include "tools/files/printable.h"
#include "tools/hyrax-sim/command_line/shell_command.h"
#include "tools/hyrax-sim/golden/check_report.h"
#include "tools/hyrax-sim/golden/difference_text.h"
#include "tools/hyrax-sim/golden/group_text.h"
#include "tools/hyrax-sim/runs/scenario_run.h"

namespace hyrax {
namespace {

using Status = CheckVerdict::Status;

constexpr const char* kUnreferenced =
    "no scenario for this golden file: the scenario was deleted, moved or renamed";

std::string missing_sentence(const CheckVerdict& verdict) {
  if (!verdict.golden)
    return "no golden file: no folder `scenarios` above it; --golden DIR names the folder to look in";
  const auto& [h5_path, txt_path] = *verdict.golden;
  const bool has_h5 = is_there(h5_path);
  if (!has_h5 && !is_there(txt_path)) return fmt::format("no golden file at {}", printable(h5_path));
  return fmt::format("no golden file at {}: {} exists, but {} is missing", printable(h5_path),
                     printable(has_h5 ? h5_path : txt_path), printable(has_h5 ? txt_path : h5_path));
}

}  // namespace

std::string broken_sentence(const CheckVerdict& verdict) {
  std::string text;
  for (const Expectation& broken : verdict.broken)
    text += (text.empty() ? "expect " : "; ") + expectation_text(broken);
  return text;
}

std::string verdict_sentence(const CheckReport& report, const CheckVerdict& verdict) {
  switch (verdict.status) {
    case Status::agreed:
      return "";
    case Status::failed:
      return verdict.error;
    case Status::unreferenced:
      return kUnreferenced;
    case Status::missing:
      return fmt::format("{}; to create it: {}", missing_sentence(verdict),
                         bless_command_for({verdict.path}, verdict.golden_folder));
    case Status::disagreed:
      break;
  }
  const DifferenceGroup* const group = report.group_of(verdict);
  const std::string broken = broken_sentence(verdict);
  if (group == nullptr) return broken.empty() ? "the state is not finite" : broken;
  return fmt::format("{}{}: {}{}", group->reproduced() == 0 ? "cause unknown: " : "", group->cause.detail,
                     scenario_consequence({verdict.path, &verdict.comparison, verdict.runs.get()}),
                     broken.empty() ? "" : "; " + broken);
}

std::string verdict_details(const CheckVerdict& verdict, bool lists_all) {
  if (verdict.status == Status::failed) return "  " + verdict.error + "\n";
  if (verdict.status == Status::unreferenced) return fmt::format("  {}\n", kUnreferenced);
  if (verdict.status == Status::agreed) return "";
  std::string text;
  for (const Expectation& broken : verdict.broken)
    text += fmt::format("  expect     {}\n", expectation_text(broken));
  const std::string bless = bless_command_for({verdict.path}, verdict.golden_folder);
  if (verdict.status == Status::missing)
    return text + fmt::format("  {}\n  to create it: {}\n", missing_sentence(verdict), bless);
  if (verdict.comparison.agrees) return text;
  return text + difference_text(verdict.comparison, lists_all) +
         fmt::format(
             "  to see more     {}; {}\n"
             "  to accept it    {}\n",
             program_command({"run", as_argument(verdict.path), "-o", "now.h5"}),
             program_command({"diff", as_argument(verdict.golden->h5_path), "now.h5"}), bless);
}

}  // namespace hyrax
