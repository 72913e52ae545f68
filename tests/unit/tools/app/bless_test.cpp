// A summary of a golden file that an earlier version wrote.
#include <gtest/gtest.h>

#include "sim/core/shipped_core.h"
#include "tests/unit/sim/replay/some_flings.h"
#include "tests/unit/tools/store/temp_folder.h"
#include "tools/app/bless/paper_blesser.h"
#include "tools/app/play/play.h"
#include "tools/files/scenario_writer.h"
#include "tools/files/summary_text.h"
#include "tools/files/text_file.h"
#include "tools/store/golden_summary.h"

namespace hyrax {
namespace {

Blessing planned(const std::string& path) {
  return plan_blessings(*blesser_of(shipped_core()), {path}, {.reason = "another"}).at(0);
}

TEST(Bless, WritesASummaryOfAnOlderLayoutAgainWithItsOwnReason) {
  const TempFolder folder;
  const std::string path = folder.at("scenarios/fling.json");
  const Scenario scenario = fling_at(60.0, 300);
  std::filesystem::create_directories(folder.at("scenarios"));
  write_text_file(path, to_text(to_json(scenario)));
  Blessing first = planned(path);
  write(*blesser_of(shipped_core()), first, "its own");
  const auto& [h5_path, txt_path, is_reserved, golden_folder] = *first.verdict->golden;
  const std::string written = read_text_file(txt_path), rows = file_checksum(h5_path);
  EXPECT_EQ(planned(path).status, Blessing::Status::unchanged);

  const FreshRun fresh = play_for_golden(shipped_core(), scenario, shipped_core());
  const std::string older = golden_summary_text(fresh.run, fresh.summary, {}, "its own", "",
                                                {contents_checksum(fresh.run), rows, summary_core(written)});
  write_text_file(txt_path, older);
  Blessing again = planned(path);
  EXPECT_EQ(again.status, Blessing::Status::changed);
  write(*blesser_of(shipped_core()), again, "another");
  EXPECT_EQ(read_text_file(txt_path), written);
  EXPECT_EQ(file_checksum(h5_path), rows);
  EXPECT_NE(older, written);
}

}  // namespace
}  // namespace hyrax
