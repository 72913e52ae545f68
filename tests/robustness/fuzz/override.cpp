// --set: every line of the input is a POINTER=VALUE put over a scenario that has something of everything.
#include "tests/robustness/fuzz/played_scenario.h"
#include "tools/files/text_file.h"

namespace hyrax {
namespace {

constexpr std::string_view kScenario = R"({
  "format": "hyrax-scenario/1", "name": "any", "description": "text",
  "window": { "width_px": 800, "height_px": 600 }, "sprite": { "width_px": 100, "height_px": 100 },
  "start": { "x_px": 350, "y_px": 0 },
  "clock": { "rate_hz": 60, "jitter": { "kind": "normal", "sigma_s": 0.002, "seed": 1 } },
  "steps": 300,
  "events": [ { "step": 20, "grab": {} }, { "step": 21, "place": { "x_px": 1, "y_px": 3 } },
              { "at_s": 1, "release": { "vx_px_per_s": 900, "vy_px_per_s": -600 } } ],
  "expect": { "in_bounds": true, "contacts": { "right": 1 }, "at_rest_since_s": [6, 9] }
})";

std::vector<Override> overrides_in(std::string_view text) {
  std::vector<Override> overrides;
  while (!text.empty()) {
    const std::string line(text.substr(0, text.find('\n')));
    text.remove_prefix(std::min(text.size(), line.size() + 1));
    const std::size_t equals = line.find('=');
    if (equals != std::string::npos) overrides.push_back({line.substr(0, equals), line.substr(equals + 1)});
  }
  return overrides;
}

}  // namespace
}  // namespace hyrax

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hyrax;
  Json document = parse_json(kScenario, "any.json");
  Scenario scenario;
  const auto read = [&] {
    for (const Override& given : overrides_in(text_of(data, size)))
      replace_value(document, given, "any.json");
    scenario = to_scenario(document, "any.json", "any");
  };
  if (accepts(read)) hold_accepted(scenario);
  return 0;
}
