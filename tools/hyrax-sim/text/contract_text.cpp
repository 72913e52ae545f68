#include "tools/hyrax-sim/text/contract_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace hyrax {
namespace {

bool both_tell(const Provenance& a, const Provenance& b, const ProvenanceField& field) {
  return a.*field.value && b.*field.value;
}

bool differs(const Provenance& a, const Provenance& b, const ProvenanceField& field) {
  return both_tell(a, b, field) && a.*field.value != b.*field.value;
}

std::string_view meaning(DifferenceClass difference, bool contracts_differ) {
  if (difference == DifferenceClass::shape)
    return "no build explains it: these are not two whole runs of one scenario and physics model";
  if (!contracts_differ)
    return "it is not how the programs were built: usually the core was changed between the runs";
  return "strict builds give the same bits under every contract: usually one of the two fuses\n"
         "             multiply-adds, or the core was changed as well; `hyrax-sim check` by each\n"
         "             of the programs tells which of them left the golden files";
}

}  // namespace

std::string contract_text(const Provenance& a, const Provenance& b, DifferenceClass difference) {
  const auto any = [&](const auto& holds) {
    return std::any_of(kProvenanceFields.begin(), kProvenanceFields.end(),
                       [&](const ProvenanceField& field) { return holds(a, b, field); });
  };
  const bool contracts_differ = any(differs);
  std::string text = fmt::format("  contracts  {}{}\n", contracts_differ ? "differ" : "are the same",
                                 any(std::not_fn(both_tell)) ? ", as far as both files tell" : "");
  for (const ProvenanceField& field : kProvenanceFields)
    if (differs(a, b, field))
      text +=
          fmt::format("  {:<10} {}: '{}' and '{}'\n", "", field.name, *(a.*field.value), *(b.*field.value));
  return text + fmt::format("  {:<10} {}\n", "meaning", meaning(difference, contracts_differ));
}

}  // namespace hyrax
