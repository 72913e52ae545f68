// The parts of a path.
#include "tools/files/path.h"

#include <gtest/gtest.h>

namespace hyrax {
namespace {

void expect_parts(std::string_view path, std::string_view folder, std::string_view stem,
                  std::string_view extension) {
  const FileName name = file_name(path);
  EXPECT_EQ(name.folder, folder) << path;
  EXPECT_EQ(name.stem, stem) << path;
  EXPECT_EQ(name.extension, extension) << path;
}

TEST(FileName, HasFolderStemAndExtension) {
  expect_parts("scenarios/flings/corner-fling.json", "scenarios/flings/", "corner-fling", ".json");
  expect_parts("corner.fling.json", "", "corner.fling", ".json");
  expect_parts("/fling", "/", "fling", "");
}

TEST(FileName, IgnoresDotsInFolderNames) {
  expect_parts("a.b/fling", "a.b/", "fling", "");
  expect_parts("../fling.json", "../", "fling", ".json");
}

TEST(FileName, OfAHiddenFileIsAllStem) { expect_parts("a/.json", "a/", ".json", ""); }

TEST(FileName, OfAFolderIsEmpty) { expect_parts("a/", "a/", "", ""); }

}  // namespace
}  // namespace hyrax
