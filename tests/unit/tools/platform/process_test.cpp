// What the system says of files, of this process and of others.
#include "tools/platform/process.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>

#include "tests/unit/tools/store/temp_folder.h"
#include "tools/platform/file_state.h"
#include "tools/platform/guarded_child.h"

namespace hyrax {
namespace {

TEST(PrintedBy, IsWhatAProgramPrintsIfItSucceeds) {
  EXPECT_EQ(printed_by({"printf", "%s-", "a b", "'\"\\"}), "a b-'\"\\-");
  EXPECT_EQ(printed_by({"false"}), std::nullopt);
  EXPECT_EQ(printed_by({"no-program-has-this-name"}), std::nullopt);
}

TEST(FileState, KnowsAFileByEachOfItsPaths) {
  const TempFolder folder;
  write_bytes(folder.at("a"), "");
  write_bytes(folder.at("b"), "");
  std::filesystem::create_symlink("a", folder.at("link"));
  EXPECT_EQ(identity_of(folder.at("a")), identity_of(folder.at("link")));
  EXPECT_NE(identity_of(folder.at("a")), identity_of(folder.at("b")));
  EXPECT_FALSE(identity_of(folder.at("none")));
}

TEST(FileState, SaysWhyAFileCannotBeUsed) {
  const TempFolder folder;
  write_bytes(folder.at("a"), "");
  EXPECT_EQ(error_of_reading(folder.at("a")), 0);
  EXPECT_EQ(error_of_reading(folder.at("none")), ENOENT);
  EXPECT_EQ(error_of_writing_in(folder.at("")), 0);
  EXPECT_EQ(error_of_writing_in(folder.at("none")), ENOENT);
  EXPECT_EQ(error_of_removing(folder.at("a")), 0);
  EXPECT_EQ(error_of_removing(folder.at("a")), 0) << "it is gone already";
  EXPECT_NE(error_of_removing(folder.at("")), 0);
}

TEST(Process, HasACacheFolderIfAnAbsolutePathNamesOne) {
  setenv("HOME", "/home/somebody", 1);
  setenv("XDG_CACHE_HOME", "/cache", 1);
  EXPECT_EQ(cache_folder(), "/cache");
  setenv("XDG_CACHE_HOME", "relative", 1);
  EXPECT_EQ(cache_folder(), "/home/somebody/.cache");
  unsetenv("HOME");
  EXPECT_EQ(cache_folder(), "");
}

TEST(Process, HasTimeThatPassesOnlyWhileItWorks) {
  const std::int64_t before_ns = thread_time_ns();
  std::uint64_t hash = 1;
  for (int turn = 0; turn < 1'000'000; ++turn) hash = hash * 31 + static_cast<std::uint64_t>(turn);
  EXPECT_NE(hash, 0u);
  EXPECT_GT(thread_time_ns(), before_ns);
  EXPECT_FALSE(processor_name().empty());
}

}  // namespace
}  // namespace hyrax
