#include "tools/files/build_info.h"

namespace hyrax {
namespace {

// From what the compiler defines; all files of the program are built with the same flags.
constexpr std::string_view instruction_set() {
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

}  // namespace

BuildInfo build_info() {
#ifdef __clang__
  constexpr std::string_view kCompiler = "clang " __clang_version__;
#else
  constexpr std::string_view kCompiler = "g++ " __VERSION__;
#endif
  return {HYRAX_VERSION, kCompiler, HYRAX_BUILD_FLAGS, HYRAX_TARGET, instruction_set()};
}

}  // namespace hyrax
