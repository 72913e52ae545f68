#include "tools/hyrax-sim/search/other_program.h"

#include <filesystem>
#include <map>
#include <utility>

#include "tools/files/failure.h"
#include "tools/files/json.h"
#include "tools/files/scenario_writer.h"

namespace hyrax {
namespace {

Scenario one_frame() {
  Scenario scenario;
  scenario.name = "one-frame";
  scenario.window = {100, 100};
  scenario.sprite = {10, 10};
  scenario.clock.base = FixedRate{};
  scenario.length = std::int64_t{1};
  return scenario;
}

// The state hashes in the output of `run --json`, by the path of each scenario's file.
std::map<std::string, std::string> printed_hashes(const std::string& output) {
  std::map<std::string, std::string> hashes;
  try {
    const Json document = parse_json(output, "run --json");
    const Json* const runs = document.find("runs");
    if (runs == nullptr || runs->get<Json::Array>() == nullptr) return {};
    for (const Json& run : *runs->get<Json::Array>()) {
      const Json* const path = run.find("scenario");
      const Json* const hash = run.find("state_hash");
      if (path == nullptr || hash == nullptr) continue;
      if (path->get<std::string>() != nullptr && hash->get<std::string>() != nullptr)
        hashes.emplace(*path->get<std::string>(), *hash->get<std::string>());
    }
  } catch (const Failure&) {
    return {};  // It was ended before it printed all, or is no hyrax-sim.
  }
  return hashes;
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

}  // namespace

OtherProgram::OtherProgram(std::string program, const std::string& option) : program_(std::move(program)) {
  const Scenario scenario = one_frame();
  ChildEnd end;
  if (!play_together({&scenario, 1}, end).front().empty()) return;
  throw Failure(ExitCode::bad_input, option + ": `" + program_ + " run FILE --json` printed no state hash (" +
                                         end_text(end, kLimit_s) + "): " + first_line(end.err));
}

std::vector<std::string> OtherProgram::state_hashes(std::span<const Scenario> scenarios) const {
  ChildEnd end;
  std::vector<std::string> hashes = play_together(scenarios, end);
  for (std::size_t index = 0; index < scenarios.size(); ++index) {
    if (!hashes[index].empty()) continue;
    if (scenarios.size() > 1) hashes[index] = play_together(scenarios.subspan(index, 1), end).front();
    if (hashes[index].empty()) hashes[index] = end_text(end, kLimit_s);
  }
  return hashes;
}

// The hash of each; empty where it printed none.
std::vector<std::string> OtherProgram::play_together(std::span<const Scenario> scenarios,
                                                     ChildEnd& end) const {
  const TemporaryFolder folder;
  const std::string inputs = folder.path() + "/in";
  std::filesystem::create_directory(inputs);
  std::vector<std::string> paths;
  for (const Scenario& scenario : scenarios)
    paths.push_back(folder.write("in/" + scenario.name + ".json", scenario_file_text(scenario)));
  end = run_child({program_, "run", inputs, "--json", "-o", folder.path() + "/out/"}, kLimit_s);
  std::map<std::string, std::string> printed = printed_hashes(end.out);
  std::vector<std::string> hashes;
  for (const std::string& path : paths) hashes.push_back(printed[path]);
  return hashes;
}

}  // namespace hyrax
