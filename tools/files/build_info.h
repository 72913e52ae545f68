// Version, compiler and flags of this build.
#pragma once

#include <string_view>

namespace hyrax {

/// The result of the self-test of arithmetic. Programs whose self-test has another one refuse to compute.
inline constexpr std::string_view kStrictArithmetic = "strict IEEE-754 double arithmetic";

struct BuildInfo {
  std::string_view version;
  std::string_view compiler;
  std::string_view flags;
  std::string_view target;
  std::string_view instruction_set;  ///< Of the build; this machine may have more.
};

[[nodiscard]] BuildInfo build_info();

/// What the core is compiled with, where that is one's own and the rest of the program was built before.
/// At start.
void set_core_build(std::string_view flags, std::string_view compiler, std::string_view instruction_set);

/// Of the source file that calls them; each has its own.
[[nodiscard]] static constexpr std::string_view compiler_here() {
#ifdef __clang__
  return "clang " __clang_version__;
#elif defined(__GNUC__)
  return "g++ " __VERSION__;
#else
  return "another compiler";
#endif
}

[[nodiscard]] static constexpr std::string_view instruction_set_here() {
#if defined(__AVX512F__) && defined(__AVX512BW__) && defined(__AVX512CD__) && defined(__AVX512DQ__) && \
    defined(__AVX512VL__)
  return "x86-64-v4";
#elif defined(__AVX2__) && defined(__BMI2__) && defined(__FMA__)
  return "x86-64-v3";
#elif defined(__x86_64__) && defined(__FMA__)
  return "x86-64 with fused multiply-add";
#elif defined(__x86_64__) && defined(__SSE4_2__)
  return "x86-64-v2";
#elif defined(__x86_64__)
  return "x86-64";
#elif defined(__SSE2_MATH__)
  return "i386 with SSE2";
#elif defined(__aarch64__)
  return "aarch64";
#elif defined(__arm__) && defined(__ARM_FEATURE_FMA)
  return "arm with fused multiply-add";
#elif defined(__arm__)
  return "arm";
#elif defined(__riscv)
  return "riscv64";
#elif defined(__s390x__)
  return "s390x";
#elif defined(__powerpc64__)
  return "powerpc64";
#elif defined(__wasm__)
  return "wasm32";
#else
  return "unknown";
#endif
}

}  // namespace hyrax
