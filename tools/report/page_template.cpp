#include "tools/report/page_template.h"

#ifdef HYRAX_PAGE_FOLDER
// The assembler copies the files' bytes, so that no compiler has to parse them.
asm(".section .rodata\n"
    "hyrax_runs_begin:\n"
    ".incbin \"" HYRAX_PAGE_FOLDER
    "/runs.html\"\n"
    "hyrax_runs_end:\n"
    "hyrax_results_begin:\n"
    ".incbin \"" HYRAX_PAGE_FOLDER
    "/results.html\"\n"
    "hyrax_results_end:\n"
    ".text\n");
extern "C" const char hyrax_runs_begin;
extern "C" const char hyrax_runs_end;
extern "C" const char hyrax_results_begin;
extern "C" const char hyrax_results_end;
#endif

namespace hyrax {

std::string_view page_template([[maybe_unused]] PageKind kind) {
#ifdef HYRAX_PAGE_FOLDER
  return kind == PageKind::runs ? std::string_view{&hyrax_runs_begin, &hyrax_runs_end}
                                : std::string_view{&hyrax_results_begin, &hyrax_results_end};
#else
  return {};
#endif
}

std::string_view page_core_fingerprint() {
  constexpr std::string_view kBegin = " data-fingerprint=\"";
  const std::string_view page = page_template(PageKind::runs);
  const std::size_t place = page.find(kBegin);
  if (place == std::string_view::npos) return {};
  const std::size_t begin = place + kBegin.size();
  return page.substr(begin, page.find('"', begin) - begin);
}

}  // namespace hyrax
