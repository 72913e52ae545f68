// Where golden files are, the parts of a path, and what a summary states.
#include <gtest/gtest.h>

#include "tests/unit/tools/store/temp_folder.h"
#include "tools/files/check_status.h"
#include "tools/files/golden_place.h"
#include "tools/files/json.h"
#include "tools/files/summary_text.h"
#include "tools/files/text_file.h"
#include "tools/platform/path.h"

namespace hyrax {
namespace {

Json::Array rows_of(const char* name) {
  const std::string path = HYRAX_SOURCE_DIR "/tests/unit/tools/files/paths.json";
  return *parse_json(read_text_file(path), path).find(name)->get<Json::Array>();
}

std::string place_of(const std::string& scenario, const std::string& golden_folder = "") {
  const auto place = golden_place(scenario, golden_folder);
  if (!place) return "none";
  const std::string stem = place->h5_path.substr(0, place->h5_path.size() - 3);
  EXPECT_EQ(place->txt_path, stem + ".txt");
  EXPECT_EQ(place->h5_path, stem + ".h5");
  return stem + (place->is_reserved ? " is reserved" : "");
}

// Each row is a scenario, the folder that is given, and the place.
TEST(GoldenPlace, IsBesideTheScenariosFolderOrBelowTheGivenOneAndOutsideOfTheFolderCoreAtItsTop) {
  for (const Json& row : rows_of("golden files")) {
    const Json::Array& texts = *row.get<Json::Array>();
    EXPECT_EQ(place_of(*texts[0].get<std::string>(), *texts[1].get<std::string>()),
              *texts[2].get<std::string>())
        << to_text(row);
  }
}

TEST(CountsSentence, HasWhatIsNotCheckedBehindIt) {
  using enum CheckStatus;
  EXPECT_EQ(counts_sentence({agreed, disagreed, disagreed, missing, failed, unreferenced}, 2),
            "5 checked: 1 agreed, 2 disagreed, 1 without golden file, 1 failed; 1 unreferenced; 2 folders "
            "failed");
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

// Each row is a path and its parts.
TEST(FileName, HasFolderStemAndExtension) {
  for (const Json& row : rows_of("names")) {
    const std::string& path = *row.get<Json::Array>()->front().get<std::string>();
    const FileName name = file_name(path);
    EXPECT_EQ(to_text(Json::Array{path, std::string(name.folder), std::string(name.stem),
                                  std::string(name.extension)}),
              to_text(row));
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
