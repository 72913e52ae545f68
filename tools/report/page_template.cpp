#include "tools/report/page_file.h"

#ifdef HYRAX_PAGE_FOLDER
// The assembler copies the files' bytes, so that no compiler has to parse them.
#define HYRAX_PAGE_OF(name)                    \
  asm(".section .rodata\n"                     \
      "hyrax_" #name                           \
      "_begin:\n"                              \
      ".incbin \"" HYRAX_PAGE_FOLDER "/" #name \
      ".html\"\n"                              \
      "hyrax_" #name                           \
      "_end:\n"                                \
      ".text\n");                              \
  extern "C" const char hyrax_##name##_begin, hyrax_##name##_end
HYRAX_PAGE_OF(runs);
HYRAX_PAGE_OF(sweeps);
#endif

namespace hyrax {

std::string_view page_template([[maybe_unused]] PageKind kind) {
#ifdef HYRAX_PAGE_FOLDER
  if (kind == PageKind::runs) return {&hyrax_runs_begin, &hyrax_runs_end};
  return {&hyrax_sweeps_begin, &hyrax_sweeps_end};
#else
  return {};
#endif
}

}  // namespace hyrax
