#include "tools/files/build_info.h"

namespace hyrax {

BuildInfo build_info() {
#ifdef __clang__
  constexpr std::string_view kCompiler = "clang " __clang_version__;
#else
  constexpr std::string_view kCompiler = "g++ " __VERSION__;
#endif
  return {HYRAX_VERSION, kCompiler, HYRAX_BUILD_FLAGS, HYRAX_TARGET};
}

}  // namespace hyrax
