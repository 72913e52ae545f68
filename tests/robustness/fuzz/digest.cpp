// The reader of golden digests: the input is the text beside a golden file.
#include "tests/robustness/fuzz/fuzz_target.h"
#include "tools/store/golden_digest.h"
#include "tools/store/golden_seal.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hyrax;
  const std::string text(text_of(data, size));
  hold(digest_reason(text).find('\n') == std::string::npos, "a reason is one line");
  if (const auto seal = seal_in(text))
    hold(text.ends_with(seal_line(*seal)), "a seal is read as it was written");
  return 0;
}
