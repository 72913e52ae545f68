// A run of a core that describes itself, as a page shows it.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "sim/described/described_figure.h"
#include "tools/report/result_page.h"

namespace hyrax {

/// Its picture, rows, contacts and end. @param found what the picture says of it.
[[nodiscard]] ShownResult shown_run(const Description& description, const DescribedScenario& scenario,
                                    const DescribedSummary& summary, const DescribedPicture& picture,
                                    const std::string& found,
                                    std::vector<std::pair<std::string, std::string>> origin);

/// Its paths, or its first values over time, for a sheet.
[[nodiscard]] Sheet panel_picture(const DescribedPicture& picture);

/// Writes the page of several runs, with a sheet of them first.
void write_run_pages(const std::string& path, const std::string& command, const std::vector<RunPanel>& panels,
                     std::vector<ShownResult> runs);

}  // namespace hyrax
