// The message of what is refused.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "tools/files/failure.h"

namespace hyrax {

/// The message of the Failure that the work ends with, empty if it ends with none. Fails the test for another
/// exit code.
inline std::string refusal_of(const auto& work, ExitCode expected = ExitCode::bad_input) {
  try {
    work();
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.exit_code(), expected) << failure.what();
    return failure.what();
  }
  return "";
}

}  // namespace hyrax
