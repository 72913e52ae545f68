// Part files: each writer has its own, and none is left over.
#include "tools/files/atomic_file.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <optional>

#include "tests/unit/tools/files/refusal.h"
#include "tests/unit/tools/store/temp_folder.h"

namespace hyrax {
namespace {

namespace fs = std::filesystem;

class PartFileTest : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return folder_.at(name); }

  const TempFolder folder_;
};

TEST_F(PartFileTest, IsAnotherForEveryWriter) {
  std::optional<AtomicFile> first(path("a.h5"));
  const AtomicFile second(path("a.h5"));
  EXPECT_EQ(first->part_path(), path(".a.h5.part"));
  EXPECT_EQ(second.part_path(), path(".a.h5.2.part"));
  EXPECT_TRUE(fs::exists(first->part_path()));
  first.reset();
  EXPECT_EQ(AtomicFile(path("a.h5")).part_path(), path(".a.h5.part"));
}

TEST_F(PartFileTest, IsAHiddenFileNextToItsTargetAlsoWhereAWriterWasKilled) {
  for (const char* const name : {".a.h5.part", ".b.h5.part"}) write_bytes(path(name), "half of a file");
  const AtomicFile part(path("a.h5"));
  EXPECT_EQ(part.part_path(), path(".a.h5.part"));
  EXPECT_EQ(fs::file_size(part.part_path()), 0u);
  EXPECT_TRUE(fs::exists(path(".b.h5.part"))) << "another output's";
}

TEST_F(PartFileTest, IsRemovedByASignalThatEndsTheProgram) {
  write_bytes(path("a.h5"), "old");
  const auto end_by = [&](int signal) {
    const AtomicFile part(path("a.h5"));
    part.write("half");
    std::raise(signal);
    std::_Exit(0);
  };
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    EXPECT_EXIT(end_by(signal), testing::KilledBySignal(signal), "");
    EXPECT_FALSE(fs::exists(path(".a.h5.part"))) << signal;
    EXPECT_EQ(fs::file_size(path("a.h5")), 3u) << signal;
  }
}

TEST_F(PartFileTest, OutlivesASignalThatIsIgnored) {
  const auto ignore_hangup = [&] {
    std::signal(SIGHUP, SIG_IGN);
    AtomicFile part(path("a.h5"));
    part.write("whole");
    std::raise(SIGHUP);
    part.commit();
    std::_Exit(0);
  };
  EXPECT_EXIT(ignore_hangup(), testing::ExitedWithCode(0), "");
  EXPECT_EQ(fs::file_size(path("a.h5")), 5u);
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

TEST_F(PartFileTest, SkipsNamesThatAreNotItsPartFiles) {
  fs::create_directory(path(".a.h5.part"));
  fs::create_symlink("victim", path(".a.h5.2.part"));
  write_bytes(path("victim"), "somebody else's");
  const AtomicFile part(path("a.h5"));
  EXPECT_EQ(part.part_path(), path(".a.h5.3.part"));
  EXPECT_EQ(fs::file_size(path("victim")), 15u);
}

TEST_F(PartFileTest, AreNotWithoutNumber) {
  const auto take = [&](int number) {
    fs::create_directory(path(number == 1 ? ".a.h5.part" : ".a.h5." + std::to_string(number) + ".part"));
  };
  for (int number = 1; number < 100; ++number) take(number);
  EXPECT_EQ(AtomicFile(path("a.h5")).part_path(), path(".a.h5.100.part"));
  take(100);
  EXPECT_EQ(refusal_of([&] { const AtomicFile part(path("a.h5")); }, ExitCode::cannot_access),
            path("a.h5") + ": cannot be written: 100 others are writing it; if none is, remove the files " +
                path(".a.h5.part") + ", .2.part and so on");
}

}  // namespace
}  // namespace hyrax
