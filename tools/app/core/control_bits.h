// The control bits of floating-point arithmetic: rounding and flush-to-zero, not the sticky flags.
#pragma once

#include <cfenv>
#include <cstdint>
#include <string>

namespace hyrax {

class ControlBits {
 public:
  ControlBits() { std::fegetenv(&environment_); }

  /// Whether they were changed since. If so, they are as they were again.
  [[nodiscard]] bool restore() const {
    if (now() == bits_) return false;
    std::fesetenv(&environment_);
    return true;
  }

 private:
  // Without saving all of the environment, which takes longer than a step.
  static std::uint64_t now() {
#if defined(__x86_64__)
    constexpr std::uint32_t kStickyFlags = 0x3f;
    std::uint16_t control_word = 0;
    __asm__ volatile("fnstcw %0" : "=m"(control_word));
    return std::uint64_t{control_word} << 32 | (__builtin_ia32_stmxcsr() & ~kStickyFlags);
#elif defined(__aarch64__)
    std::fenv_t environment{};
    std::fegetenv(&environment);
    return environment.__fpcr;
#else
    return static_cast<std::uint64_t>(std::fegetround());
#endif
  }

  std::fenv_t environment_{};
  std::uint64_t bits_ = now();
};

/// What is said of a core that changes them. @param where as " in the step that makes row 3".
[[nodiscard]] inline std::string control_bits_message(const std::string& where) {
  return "the core changes how the processor calculates (rounding or flush-to-zero)" + where +
         "; remove what sets it from the core";
}

}  // namespace hyrax
