#include <gsl/gsl_version.h>

#include "sim/core/core.h"
#include "sim/core/core_record.h"
#include "sim/trace/step_text.h"
#include "tools/app/command_line/options.h"
#include "tools/files/json.h"
#include "tools/store/build_facts.h"

namespace hyrax {
namespace {

// What the build could record of the core's step.
std::string step_fact(const Core& core) {
  const CoreRecord& record = core.record;
  if (!record.why_incomplete.empty()) return fmt::format("not complete: {}", record.why_incomplete);
  return fmt::format("complete, {} paths",
                     read_step(record.step).value().paths_of(CoreFunction::update).size());
}

std::string contacts_fact(const Core& core) {
  const std::string others = core.sources();
  if (core.walls_of_rows == kAllWalls) return others;
  return "from the step's comparisons" + (others.empty() ? "" : "; " + others);
}

Json::Object facts(const Core& core) {
  Json::Object all = build_facts();
  all.emplace_back("physics", core.name);
  all.emplace_back("step", step_fact(core));
  all.emplace_back("contacts", contacts_fact(core));
  for (auto& fact : library_facts()) all.push_back(std::move(fact));
  all.emplace_back("gsl", gsl_version);
  return all;
}

ExitCode info(const Core& core, const Printing& printing) {
  const Json::Object all = facts(core);
  if (printing.is_json)
    print_json(all, 1);
  else
    for (const auto& [name, value] : all)
      if (!printing.is_quiet() || name == "self_test")
        print_text("{:<16} {}\n", name, *value.get<std::string>());
  return ExitCode::agreed;
}

}  // namespace

Command info_command() {
  return {.name = "info",
          .summary = "print build, flags, instruction set, library versions and the result of the self-test",
          .example = "hyrax-sim info",
          .needs_strict_ieee = false,
          .declare = with_request<Printing>(
              [](Options& options, Printing& printing) { options.printing(printing); }, info)};
}

}  // namespace hyrax
