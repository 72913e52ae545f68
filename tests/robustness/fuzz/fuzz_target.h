// What a fuzzer, or a replay of inputs it once found, calls.
//
// A target reads an input as the program reads an untrusted file. It may refuse it with a Failure of
// bad input, and must not crash, hang, use memory out of proportion or break the invariants that the
// target checks for accepted input.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string_view>

#include "tools/files/failure.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace hyrax {

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// Ends the process where what must hold of every input does not.
inline void hold(bool holds, const char* sentence) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n", sentence);
  std::abort();
}

/// Whether `read` accepts the input; an answer of any other kind than "bad input" is a fault.
inline bool accepts(const std::function<void()>& read) {
  try {
    read();
    return true;
  } catch (const Failure& failure) {
    hold(failure.exit_code() == ExitCode::bad_input, failure.what());
    hold(std::string_view(failure.what()).size() > 10, "a refusal says what is wrong");
    return false;
  }
}

}  // namespace hyrax
