#include "tools/run_core/run_core.h"

#include <utility>

#include "sim/core/listing_core.h"
#include "tools/files/failure.h"
#include "tools/files/json_pointer.h"
#include "tools/files/printable.h"
#include "tools/files/unknown_word.h"

namespace hyrax {

Core run_core(const Core& core, const std::string& path, const Scenario& scenario) {
  if (auto played = with_parameters(core, scenario.parameters)) return *std::move(played);
  const auto refuse = [&](const std::string& place, const std::string& sentence) {
    refuse_input(printable(path + ": " + place + ": " + sentence));
  };
  std::vector<std::string_view> names(core.constant_names.begin(), core.constant_names.end());
  std::erase(names, "");
  if (!core.paper_match.constants)
    refuse("/parameters",
           "needs a core of the same shape, the paper's step with other constants (found the core " +
               std::string(core.name) + ", " + core.paper_match.difference +
               "); change its constants in its header");
  if (names.empty())
    refuse("/parameters",
           "the constants of the core " + std::string(core.name) +
               " are not known by name; known are those of its class with the paper's names, as double: " +
               listed(kPaperNames));
  Constants ignored;
  const std::string name = set_parameters(scenario.parameters, core.constant_names, ignored)->name;
  refuse(pointer_to("/parameters", name), unknown_word("constant of the core", name, names));
  return core;
}

}  // namespace hyrax
