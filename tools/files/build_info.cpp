#include "tools/files/build_info.h"

namespace hyrax {
namespace {

BuildInfo info = {HYRAX_VERSION, compiler_here(), HYRAX_BUILD_FLAGS, HYRAX_TARGET, instruction_set_here()};

}  // namespace

BuildInfo build_info() { return info; }

void set_core_build(std::string_view flags, std::string_view compiler, std::string_view instruction_set) {
  info.flags = flags;
  info.compiler = compiler;
  info.instruction_set = instruction_set;
}

}  // namespace hyrax
