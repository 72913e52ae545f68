// Runs of a core that describes itself, and how two differ, as text, as JSON and on pages.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sim/described/described_comparison.h"
#include "sim/described/described_figure.h"
#include "tools/described/trajectory_file.h"
#include "tools/files/json.h"
#include "tools/report/result_page.h"

namespace hyrax {

/// "rail 3, floor 0"; "none" of a core without contacts.
[[nodiscard]] std::string contacts_text(const Description& description, const DescribedSummary& summary);

/// REQUIRES: the run has not settled.
[[nodiscard]] std::string why_not_settled(const Description& description, const DescribedSummary& summary);

/// "a.x_px 12.5 px, mood calm", of at most so many values, then "and 3 more".
[[nodiscard]] std::string state_text(const Description& description, const std::vector<Word>& state,
                                     std::size_t values_max);

/// Why a run does not hold, whatever it is compared with: its early end, and each `always` that is broken.
[[nodiscard]] std::vector<std::string> faults_of_run(const Description& description,
                                                     const DescribedSummary& summary);

/// What a user of the program would see. One line.
[[nodiscard]] std::string comparison_sentence(const DescribedComparison& comparison);
/// Complete lines, indented by two.
[[nodiscard]] std::string comparison_text(const DescribedComparison& comparison);
/// {"class", "max_px", "max", "contacts_moved", "first_divergence"}
[[nodiscard]] Json::Object comparison_json(const DescribedComparison& comparison);

/// A run, as its file has it. ERRORS: as DescribedFile::open's.
class FileRun final : public DescribedSink {
 public:
  FileRun(const DescribedCore& core, const std::string& path);
  void row(const DescribedRow& row) override;

  [[nodiscard]] const DescribedFile& file() const { return file_; }
  [[nodiscard]] const DescribedSummary& summary() const { return summary_; }
  [[nodiscard]] const DescribedPicture& picture() const { return picture_; }

 private:
  DescribedFile file_;
  DescribedPicture picture_;
  DescribedSummary summary_ = {};
};

/// To be drawn behind another; null of none, and of a golden file that does not hold every row.
[[nodiscard]] inline const DescribedPicture* picture_of(const std::unique_ptr<FileRun>& golden) {
  return golden && golden->file().holds_every_row() ? &golden->picture() : nullptr;
}

/// Its picture, rows, contacts and end. @param found what the picture says of it. @param golden behind it;
/// may be null.
[[nodiscard]] ShownResult shown_run(const Description& description, const DescribedScenario& scenario,
                                    const DescribedSummary& summary, const DescribedPicture& picture,
                                    const DescribedPicture* golden, const std::string& found,
                                    std::vector<std::pair<std::string, std::string>> origin);

/// Its paths, or its first values over time, for a sheet.
[[nodiscard]] Sheet panel_picture(const DescribedPicture& picture, const DescribedPicture* golden);

/// Writes the page of several runs, with a sheet of them first.
void write_run_pages(const std::string& path, const std::string& command, const std::vector<RunPanel>& panels,
                     std::vector<ShownResult> runs);

}  // namespace hyrax
