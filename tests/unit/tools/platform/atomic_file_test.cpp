// Atomic writing leaves the old file or the complete new one, and nothing else.
#include "tools/platform/atomic_file.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>

#include <sys/stat.h>

#include "tests/unit/tools/files/refusal.h"
#include "tests/unit/tools/store/temp_folder.h"
#include "tools/files/text_file.h"

namespace hyrax {
namespace {

namespace fs = std::filesystem;

using Names = std::vector<std::string>;

class AtomicFileTest : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return folder_.at(name); }
  std::string old_file(const std::string& name) const {
    write_bytes(path(name), "old");
    return path(name);
  }
  static std::string refusal(const std::string& path) {
    return refusal_of([&] { write_text_file(path, "new"); }, ExitCode::cannot_access);
  }

  const TempFolder folder_;
};

TEST_F(AtomicFileTest, IsCompleteKeepsTheModeOfTheFileThatItReplacesAndIsReadableForOthersIfNew) {
  const std::string text = std::string("a\0b\r\n", 5) + std::string(200'000, 'x');
  struct stat found {};
  for (const mode_t mode : {0600u, 0640u, 0444u, 0666u}) {
    const std::string path = old_file("a.txt");
    ASSERT_EQ(chmod(path.c_str(), mode), 0);
    {
      AtomicFile file(path);
      ASSERT_EQ(stat(file.part_path().c_str(), &found), 0);
      EXPECT_EQ(found.st_mode & 07777, mode | 0600u) << "while it is written";
      file.write("new");
      file.commit();
    }
    ASSERT_EQ(stat(path.c_str(), &found), 0);
    EXPECT_EQ(found.st_mode & 07777, mode);
    EXPECT_EQ(read_text_file(path), "new");
    fs::remove(path);
  }
  const mode_t before = umask(022);
  write_text_file(path("a.txt"), text);
  umask(before);
  ASSERT_EQ(stat(path("a.txt").c_str(), &found), 0);
  EXPECT_EQ(found.st_mode & 0777u, 0644u);
  EXPECT_EQ(read_text_file(path("a.txt")), text);
  EXPECT_EQ(folder_.names(), Names{"a.txt"});
}

TEST_F(AtomicFileTest, AcceptsANewNameOnly) {
  for (const std::string name : {"new.txt", "taken.txt"}) {
    AtomicFile file(path(name));
    file.write("new");
    if (name == "new.txt")
      file.commit_as_new();
    else
      EXPECT_EQ(refusal_of([&] { old_file(name), file.commit_as_new(); }, ExitCode::cannot_access),
                path(name) + ": cannot be written: File exists");
  }
  EXPECT_EQ(read_text_file(path("new.txt")), "new");
  EXPECT_EQ(read_text_file(path("taken.txt")), "old");
  EXPECT_EQ(folder_.names(), (Names{"new.txt", "taken.txt"}));
}

TEST_F(AtomicFileTest, LeavesWhatIsThereUntilTheNewFileIsCompleteAndWhereItIsGivenUp) {
  {
    AtomicFile file(old_file("a.txt")), taken(path("b"));
    file.write("half");
    EXPECT_EQ(read_text_file(path("a.txt")), "old");
    fs::create_directories(path("b") + "/c");  // Takes its name meanwhile.
    EXPECT_EQ(refusal_of([&] { taken.commit(); }, ExitCode::cannot_access),
              path("b") + ": cannot be written: Is a directory");
  }
  EXPECT_EQ(read_text_file(path("a.txt")), "old");
  EXPECT_EQ(folder_.names(), (Names{"a.txt", "b"}));
}

TEST_F(AtomicFileTest, KeepsTwoWritersApart) {
  AtomicFile first(path("a.txt"));
  AtomicFile second(path("a.txt"));
  EXPECT_EQ(first.part_path(), path(".a.txt.part"));
  EXPECT_EQ(second.part_path(), path(".a.txt.2.part"));
  first.write("first");
  second.write("second");
  second.commit();
  first.commit();
  EXPECT_EQ(read_text_file(path("a.txt")), "first");
  EXPECT_EQ(folder_.names(), Names{"a.txt"});
}

TEST_F(AtomicFileTest, FollowsALinkToItsFileAlsoIfThatIsMissing) {
  old_file("target.txt");
  fs::create_symlink("target.txt", path("link.txt"));
  fs::create_symlink(path("link.txt"), path("link-to-link.txt"));
  write_text_file(path("link-to-link.txt"), "new");
  EXPECT_TRUE(fs::is_symlink(path("link-to-link.txt")));
  EXPECT_TRUE(fs::is_symlink(path("link.txt")));
  EXPECT_FALSE(fs::is_symlink(path("target.txt")));
  EXPECT_EQ(read_text_file(path("target.txt")), "new");
  fs::remove(path("target.txt"));
  write_text_file(path("link.txt"), "newer");
  EXPECT_TRUE(fs::is_symlink(path("link.txt")));
  EXPECT_EQ(read_text_file(path("target.txt")), "newer");
}

TEST_F(AtomicFileTest, RefusesWhatCannotBeAFile) {
  fs::create_directory(path("folder"));
  fs::create_symlink("circle", path("circle"));
  ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
  for (const auto& [file, reason] : {std::pair{path("folder"), "Is a directory"},
                                     {path("circle"), "Too many levels of symbolic links"},
                                     {path("pipe"), "is a device or a pipe"},
                                     {path("no/such/file.txt"), "No such file or directory"},
                                     {old_file("a.txt") + "/b.txt", "Not a directory"},
                                     {path(std::string(300, 'a')), "File name too long"}})
    EXPECT_EQ(refusal(file), file + ": cannot be written: " + reason);
  EXPECT_EQ(folder_.names(), (Names{"a.txt", "circle", "folder", "pipe"}));
  EXPECT_TRUE(fs::is_fifo(path("pipe")));
}

// Each writer has its own, and none is left over.
class PartFileTest : public AtomicFileTest {};

TEST_F(PartFileTest, IsAHiddenFileNextToItsTargetAlsoWhereAWriterWasKilled) {
  for (const char* const name : {".a.h5.part", ".b.h5.part"}) write_bytes(path(name), "half of a file");
  {
    AtomicFile part(path("a.h5"));
    EXPECT_EQ(part.part_path(), path(".a.h5.part"));
    EXPECT_EQ(fs::file_size(part.part_path()), 0u);
    EXPECT_TRUE(fs::exists(path(".b.h5.part"))) << "another output's";
  }
  // Names that are not its part files.
  fs::create_directory(path(".a.h5.part"));
  fs::create_symlink("victim", path(".a.h5.2.part"));
  write_bytes(path("victim"), "somebody else's");
  EXPECT_EQ(AtomicFile(path("a.h5")).part_path(), path(".a.h5.3.part"));
  EXPECT_EQ(fs::file_size(path("victim")), 15u);
}

TEST_F(PartFileTest, IsRemovedByASignalThatEndsTheProgramAndOutlivesOneThatIsIgnored) {
  old_file("a.h5");
  const auto raise_in_writing = [&](int signal, bool is_ignored) {
    if (is_ignored) std::signal(signal, SIG_IGN);
    AtomicFile part(path("a.h5"));
    part.write("whole");
    std::raise(signal);
    part.commit();
    std::_Exit(0);
  };
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    EXPECT_EXIT(raise_in_writing(signal, false), testing::KilledBySignal(signal), "");
    EXPECT_EQ(folder_.names(), Names{"a.h5"}) << signal;
    EXPECT_EQ(read_text_file(path("a.h5")), "old") << signal;
  }
  EXPECT_EXIT(raise_in_writing(SIGHUP, true), testing::ExitedWithCode(0), "");
  EXPECT_EQ(read_text_file(path("a.h5")), "whole");
}

// A path that is kept is the next writer's, who may be in another process.
TEST_F(PartFileTest, IsAnothersAfterItsCommit) {
  const auto end_after_commit = [&] {
    AtomicFile part(path("a.h5"));
    const std::string part_path = part.part_path();
    part.commit();
    write_bytes(part_path, "another's");
    std::raise(SIGTERM);
  };
  EXPECT_EXIT(end_after_commit(), testing::KilledBySignal(SIGTERM), "");
  EXPECT_EQ(fs::file_size(path(".a.h5.part")), 9u);
}

TEST_F(PartFileTest, AreNotWithoutNumber) {
  fs::create_directory(path(".a.h5.part"));
  for (int number = 2; number <= 100; ++number) {
    const std::string part = path(".a.h5." + std::to_string(number) + ".part");
    EXPECT_EQ(AtomicFile(path("a.h5")).part_path(), part);
    fs::create_directory(part);
  }
  EXPECT_EQ(refusal_of([&] { const AtomicFile part(path("a.h5")); }, ExitCode::cannot_access),
            path("a.h5") + ": cannot be written: 100 others are writing it; if none is, remove the files " +
                path(".a.h5.part") + ", .2.part and so on");
}

TEST(MoreSerious, FollowsThePublishedOrder) {
  const ExitCode order[] = {ExitCode::agreed,         ExitCode::disagreed,     ExitCode::golden_missing,
                            ExitCode::bad_input,      ExitCode::cannot_access, ExitCode::program_fault,
                            ExitCode::not_strict_ieee};
  for (std::size_t a = 0; a < std::size(order); ++a)
    for (std::size_t b = 0; b < std::size(order); ++b)
      EXPECT_EQ(more_serious(order[a], order[b]), order[std::max(a, b)]);
}

}  // namespace
}  // namespace hyrax
