#include "tools/hyrax/playback.h"

#include <gtest/gtest.h>

#include "tests/unit/tools/store/temp_folder.h"
#include "tools/files/text_file.h"

namespace hyrax {
namespace {

std::string scenario_with(const std::string& more) {
  return R"({"format": "hyrax-scenario/1", "window": {"width_px": 800, "height_px": 600}, "steps": 1,
             "sprite": {"width_px": 8, "height_px": 8}, "clock": {"rate_hz": 60}, "start": {"x_px": 1, "y_px": 2})" +
         more + "}";
}

TEST(LoadForPet, RefusesOtherConstantsThanThePets) {
  const TempFolder folder;
  const std::string path = folder.at("calm.json");
  write_text_file(path, scenario_with(""));
  EXPECT_EQ(load_for_pet(path).name, "calm");
  write_text_file(path, scenario_with(R"(, "parameters": {"GRAVITY": 980})"), true);
  try {
    static_cast<void>(load_for_pet(path));
    FAIL();
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.exit_code(), ExitCode::bad_input);
    EXPECT_EQ(failure.what(),
              path + ": /parameters: hyrax plays its own constants only; hyrax-sim run plays these");
  }
}

}  // namespace
}  // namespace hyrax
