#include "tools/run_core/run_core.h"

#include <algorithm>
#include <utility>

#include "sim/core/listing_core.h"
#include "tools/files/failure.h"
#include "tools/files/json_pointer.h"
#include "tools/files/printable.h"
#include "tools/files/unknown_word.h"

namespace hyrax {

Core run_core(const Core& core, const std::string& path, const Scenario& scenario) {
  if (auto played = with_parameters(core, scenario.parameters)) return *std::move(played);
  const auto refuse = [&](const std::string& sentence) {
    refuse_input(printable(path + ": /parameters: " + sentence));
  };
  std::vector<std::string_view> names(core.constant_names.begin(), core.constant_names.end());
  std::erase(names, "");
  if (!core.paper_match.constants)
    refuse("needs a core of the same shape, the paper's step with other constants (found the core " +
           std::string(core.name) + ", " + core.paper_match.difference +
           "); change its constants in its header");
  if (names.empty())
    refuse("the constants of the core " + std::string(core.name) +
           " are not known by name; known are those of its class with the paper's names, as double: " +
           listed(kPaperNames));
  std::string unknown;
  for (const auto& [name, value] : scenario.parameters)
    if (std::ranges::find(names, name) == names.end())
      unknown +=
          (unknown.empty() ? "" : "\n") + printable(path + ": " + pointer_to("/parameters", name) + ": " +
                                                    unknown_word("constant of the core", name, names));
  refuse_input(unknown);
}

}  // namespace hyrax
