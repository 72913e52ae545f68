// The scenario reader: the input is the text of a scenario file.
#include "tests/robustness/fuzz/played_scenario.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hyrax;
  Scenario scenario;
  const auto read = [&] { scenario = parse_scenario(text_of(data, size), "input.json"); };
  if (accepts(read)) hold_accepted(scenario);
  return 0;
}
