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

Sheet panel_picture(const DescribedPicture& picture) {
  const Figure figure = picture.figure("");
  const auto& plots = std::get<std::vector<Plot>>(figure.body);
  return plots.empty() ? Sheet() : plot_panel(plots.front());
}

void write_run_pages(const std::string& path, const std::string& command, const std::vector<RunPanel>& panels,
                     std::vector<ShownResult> runs) {
  if (panels.size() > 1) runs.insert(runs.begin(), {.title = sheet_title(panels), .panels = panels});
  write_result_page(path, command, runs);
}

}  // namespace hyrax
