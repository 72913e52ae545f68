#include "tools/files/path.h"

#include <gtest/gtest.h>

namespace hyrax {
namespace {

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

}  // namespace
}  // namespace hyrax
