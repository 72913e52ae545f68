#include "tools/described/run_page.h"

#include "tools/described/run_text.h"

namespace hyrax {

ShownResult shown_run(const Description& description, const DescribedScenario& scenario,
                      const DescribedSummary& summary, const DescribedPicture& picture,
                      const std::string& found, std::vector<std::pair<std::string, std::string>> origin) {
  ShownResult shown{.title = scenario.name,
                    .subtitle = scenario.description.value_or(""),
                    .tables = {picture.rows()},
                    .figures = {picture.figure(found)},
                    .origin = std::move(origin)};
  shown.verdict.text = {
      "Contacts: " + contacts_text(description, summary),
      "End: " + state_text(description, summary.final, summary.final.size()),
      "The page replays cores of the paper's interface; of " + description.core + " it shows the rows."};
  return shown;
}

}  // namespace hyrax
