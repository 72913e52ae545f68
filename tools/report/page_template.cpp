#include "tools/report/page_template.h"

#ifdef HYRAX_PAGE_FILE
// The assembler copies the file's bytes, so that no compiler has to parse them.
asm(".section .rodata\n"
    "hyrax_page_begin:\n"
    ".incbin \"" HYRAX_PAGE_FILE
    "\"\n"
    "hyrax_page_end:\n"
    ".text\n");
extern "C" const char hyrax_page_begin;
extern "C" const char hyrax_page_end;
#endif

namespace hyrax {

std::string_view page_template() {
#ifdef HYRAX_PAGE_FILE
  return {&hyrax_page_begin, &hyrax_page_end};
#else
  return {};
#endif
}

}  // namespace hyrax
