#include "tools/files/golden_place.h"

#include <gtest/gtest.h>

#include "tests/unit/tools/store/temp_folder.h"
#include "tools/files/check_status.h"

namespace hyrax {
namespace {

std::string place_of(const std::string& scenario, const std::string& golden_folder = "") {
  const auto place = golden_place(scenario, golden_folder);
  if (!place) return "none";
  EXPECT_EQ(place->h5_path.substr(0, place->h5_path.size() - 3),
            place->txt_path.substr(0, place->txt_path.size() - 4));
  EXPECT_TRUE(place->txt_path.ends_with(".txt"));
  return place->h5_path;
}

TEST(GoldenPlace, IsBesideTheScenariosFolder) {
  for (const auto& [scenario, place] :
       {std::pair{"scenarios/flings/first-fling.json", "golden/flings/first-fling.h5"},
        {"a/b/scenarios/x.json", "a/b/golden/x.h5"},
        {"/data/scenarios/deep/er/x.json", "/data/golden/deep/er/x.h5"},
        // The nearest one.
        {"scenarios/old/scenarios/hard/x.json", "scenarios/old/golden/hard/x.h5"},
        {"scenarios/my-scenarios/x.json", "golden/my-scenarios/x.h5"},
        // However the path is written.
        {"./scenarios/./flings/x.json", "golden/flings/x.h5"},
        {"scenarios/flings/../clocks/x.json", "golden/clocks/x.h5"},
        {"scenarios//x.json", "golden/x.h5"},
        {"scenarios/v1.2/a.b.json", "golden/v1.2/a.b.h5"},
        {"/data/flings/x.json", "none"},
        {"/data/scenarios-old/x.json", "none"}})
    EXPECT_EQ(place_of(scenario), place);
}

TEST(GoldenPlace, IsBelowTheGivenFolder) {
  EXPECT_EQ(place_of("scenarios/flings/x.json", "/elsewhere"), "/elsewhere/flings/x.h5");
  EXPECT_EQ(place_of("/data/scenarios/a/b/x.json", "other"), "other/a/b/x.h5");
  EXPECT_EQ(place_of("/data/flings/x.json", "/elsewhere"), "/elsewhere/x.h5");
  EXPECT_EQ(place_of("/data/flings/x.json", "/elsewhere/"), "/elsewhere/x.h5");
}

TEST(GoldenPlace, ReservesTheFolderCoreAtTheTopOfScenarios) {
  for (const char* const scenario : {"scenarios/core/x.json", "scenarios/core/deep/x.json"})
    EXPECT_TRUE(golden_place(scenario, "")->is_reserved) << scenario;
  for (const char* const scenario :
       {"scenarios/core.json", "scenarios/a/core/x.json", "core/scenarios/x.json"})
    EXPECT_FALSE(golden_place(scenario, "")->is_reserved) << scenario;
}

TEST(CountsSentence, HasWhatIsNotCheckedBehindIt) {
  using enum CheckStatus;
  EXPECT_EQ(counts_sentence({agreed, disagreed, disagreed, missing, failed, unreferenced}, 0),
            "5 checked: 1 agreed, 2 disagreed, 1 without golden file, 1 failed; 1 unreferenced");
  EXPECT_EQ(counts_sentence({}, 2),
            "0 checked: 0 agreed, 0 disagreed, 0 without golden file, 0 failed; 2 folders failed");
}

TEST(GoldenPlace, FollowsALinkBeforeDots) {
  const TempFolder folder;
  std::filesystem::create_directories(folder.at("real/deep"));
  std::filesystem::create_directory_symlink(folder.at("real/deep"), folder.at("link"));
  EXPECT_EQ(place_of(folder.at("link/../scenarios/x.json")), folder.at("real/golden/x.h5"));
  EXPECT_EQ(place_of(folder.at("link/.././scenarios/a/../x.json")), folder.at("real/golden/x.h5"));
  EXPECT_EQ(golden_folder_of(folder.at("link/../scenarios/a/x.json")), folder.at("real/golden"));
  EXPECT_EQ(golden_folder_of(folder.at("link/x.json")), "");
}

TEST(GoldenPlace, IsFoundFromWithinTheScenariosFolder) {
  const TempFolder folder;
  std::filesystem::create_directories(folder.at("scenarios/flings"));
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder.at("scenarios/flings"));
  EXPECT_EQ(place_of("x.json"), folder.at("golden/flings/x.h5"));
  EXPECT_EQ(place_of("../x.json"), folder.at("golden/x.h5"));
  std::filesystem::current_path(before);
}

}  // namespace
}  // namespace hyrax
