// Where golden files are, the parts of a path, and what a summary states.
#include <gtest/gtest.h>

#include "tests/unit/tools/store/temp_folder.h"
#include "tools/files/check_status.h"
#include "tools/files/golden_place.h"
#include "tools/files/path.h"
#include "tools/files/summary_text.h"

namespace hyrax {
namespace {

std::string place_of(const std::string& scenario, const std::string& golden_folder = "") {
  const auto place = golden_place(scenario, golden_folder);
  if (!place) return "none";
  const std::string stem = place->h5_path.substr(0, place->h5_path.size() - 3);
  EXPECT_EQ(place->txt_path, stem + ".txt");
  EXPECT_EQ(place->h5_path, stem + ".h5");
  return stem;
}

TEST(GoldenPlace, IsBesideTheScenariosFolderOrBelowTheGivenOne) {
  for (const auto& [scenario, place] :
       {std::pair{"scenarios/flings/first-fling.json", "golden/flings/first-fling"},
        {"a/b/scenarios/x.json", "a/b/golden/x"},
        {"/data/scenarios/deep/er/x.json", "/data/golden/deep/er/x"},
        // The nearest one.
        {"scenarios/old/scenarios/hard/x.json", "scenarios/old/golden/hard/x"},
        {"scenarios/my-scenarios/x.json", "golden/my-scenarios/x"},
        // However the path is written.
        {"./scenarios/./flings/x.json", "golden/flings/x"},
        {"scenarios/flings/../clocks/x.json", "golden/clocks/x"},
        {"scenarios//x.json", "golden/x"},
        {"scenarios/v1.2/a.b.json", "golden/v1.2/a.b"},
        {"/data/flings/x.json", "none"},
        {"/data/scenarios-old/x.json", "none"}})
    EXPECT_EQ(place_of(scenario), place);
  EXPECT_EQ(place_of("scenarios/flings/x.json", "/elsewhere"), "/elsewhere/flings/x");
  EXPECT_EQ(place_of("/data/scenarios/a/b/x.json", "other"), "other/a/b/x");
  for (const char* const folder : {"/elsewhere", "/elsewhere/"})
    EXPECT_EQ(place_of("/data/flings/x.json", folder), "/elsewhere/x");
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

TEST(GoldenPlace, FollowsALinkBeforeDotsAndIsFoundFromWithinTheScenariosFolder) {
  const TempFolder folder;
  std::filesystem::create_directories(folder.at("real/deep"));
  std::filesystem::create_directory_symlink(folder.at("real/deep"), folder.at("link"));
  EXPECT_EQ(place_of(folder.at("link/../scenarios/x.json")), folder.at("real/golden/x"));
  EXPECT_EQ(place_of(folder.at("link/.././scenarios/a/../x.json")), folder.at("real/golden/x"));
  EXPECT_EQ(golden_folder_of(folder.at("link/../scenarios/a/x.json")), folder.at("real/golden"));
  EXPECT_EQ(golden_folder_of(folder.at("link/x.json")), "");
  std::filesystem::create_directories(folder.at("scenarios/flings"));
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder.at("scenarios/flings"));
  EXPECT_EQ(place_of("x.json"), folder.at("golden/flings/x"));
  EXPECT_EQ(place_of("../x.json"), folder.at("golden/x"));
  std::filesystem::current_path(before);
}

TEST(FileName, HasFolderStemAndExtension) {
  struct Case {
    std::string_view path, folder, stem, extension;
  };
  for (const Case& each :
       {Case{"scenarios/flings/corner-fling.json", "scenarios/flings/", "corner-fling", ".json"},
        {"corner.fling.json", "", "corner.fling", ".json"},
        {"/fling", "/", "fling", ""},
        // Dots in names of folders, a hidden file, a folder.
        {"a.b/fling", "a.b/", "fling", ""},
        {"../fling.json", "../", "fling", ".json"},
        {"a/.json", "a/", ".json", ""},
        {"a/", "a/", "", ""}}) {
    const FileName name = file_name(each.path);
    EXPECT_EQ(name.folder, each.folder) << each.path;
    EXPECT_EQ(name.stem, each.stem) << each.path;
    EXPECT_EQ(name.extension, each.extension) << each.path;
  }
}

TEST(SummaryStateHash, IsThatOfItsLineAndEmptyWhereNoneIsStated) {
  const std::string hash = "c0ea1a610d86b14114d3cef7071362e5";
  EXPECT_EQ(summary_state_hash("scenario: a\nstate hash: " + hash + "\nend: t 10 s\n"), hash);
  EXPECT_EQ(summary_state_hash("scenario: a\nstate hash: " + hash), hash);
  for (const std::string& line : {std::string(), std::string("state hash: "), "state hash: " + hash.substr(1),
                                  "state hash: " + hash + "0", "state hash: " + hash + "\r",
                                  "state hash: C" + hash.substr(1), " state hash: " + hash, "hash: " + hash})
    EXPECT_EQ(summary_state_hash("scenario: a\n" + line + "\nend: t 10 s\n"), "") << line;
}

TEST(SummaryReason, IsOneLine) {
  EXPECT_EQ(summary_reason("scenario: a\nreason: a longer throw\nreason: b\n"), "a longer throw");
  EXPECT_EQ(summary_reason("scenario: a\n"), "");
}

}  // namespace
}  // namespace hyrax
