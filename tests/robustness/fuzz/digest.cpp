// Reads the summaries of golden files: the input is the text of one.
#include "tests/robustness/fuzz/fuzz_target.h"
#include "tools/files/summary_text.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hyrax;
  const std::string text(text_of(data, size));
  hold(summary_reason(text).find('\n') == std::string::npos, "a reason is one line");
  if (const auto checksum = summary_file_checksum(text))
    hold(text.ends_with(*checksum + "\n"), "the checksum is the end of the text");
  return 0;
}
