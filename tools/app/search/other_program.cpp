#include "tools/app/search/broken_rule.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "tools/files/child_process.h"
#include "tools/files/failure.h"
#include "tools/files/json.h"
#include "tools/files/scenario_writer.h"
#include "tools/files/temporary_folder.h"

namespace hyrax {
namespace {

constexpr std::size_t kOutBytesMax = 16 << 20;     // Of a batch's document, some 0.5 MiB.
const std::string kNoHash = std::string(32, '0');  // Which no run has.

// Meets the right wall and the ground, with a gravity and a drag that act: whoever changes a result changes
// this one.
Scenario probe() {
  Scenario scenario;
  scenario.name = "probe";
  scenario.window = {640, 480};
  scenario.sprite = {64, 64};
  scenario.start = {300.0, 100.0};
  scenario.start_velocity = {1234.5, 67.8};
  scenario.clock.base = FixedRate{};
  scenario.length = std::int64_t{120};
  return scenario;
}

using Hashes = std::map<std::string, std::string>;  // By the path of the scenario's file.

// The entries of an array; nothing if there is none.
std::span<const Json> entries(const Json& object, std::string_view key) {
  const auto* const array = object.get<Json::Array>(key);
  return array == nullptr ? std::span<const Json>() : *array;
}

// Of `run --json`, or of `check --json`, which says what it measured where another hash is expected.
Hashes hashes_in(const Json& document) {
  Hashes hashes;
  for (const char* const list : {"runs", "results"})
    for (const Json& entry : entries(document, list)) {
      const auto* const path = entry.get<std::string>("scenario");
      const auto* hash = entry.get<std::string>("state_hash");
      for (const Json& expectation : entries(entry, "expect"))
        if (const auto* const rule = expectation.get<std::string>("rule");
            rule != nullptr && *rule == "state_hash")
          hash = expectation.get<std::string>("measured");
      if (path != nullptr && hash != nullptr) hashes.emplace(*path, *hash);
    }
  return hashes;
}

Json parsed(const std::string& output) {
  try {
    return parse_json(output, "--json");
  } catch (const Failure&) {
    return {};  // It was ended before it printed all, or is no hyrax-sim.
  }
}

}  // namespace

// `check` is used only if it says the same as `run`, whose output is the older interface.
OtherProgram::OtherProgram(std::string program, const std::string& option,
                           std::optional<SteadyClock::time_point> deadline, double limit_s)
    : program_(std::move(program)), limit_s_(limit_s), deadline_(deadline) {
  const Scenario scenario = probe();
  const double given_s = left_s();
  ChildEnd end;
  const std::string hash = query(Query::run, {&scenario, 1}, end).front();
  if (hash.empty())
    refuse_input(option + ": `" + program_ + " run FILE --json` printed no state hash (" +
                 end_text(end, given_s) + "): " + end.err.substr(0, end.err.find('\n')));
  uses_check_ = query(Query::check, {&scenario, 1}, end).front() == hash;
}

std::vector<std::string> OtherProgram::state_hashes(std::span<const Scenario> scenarios) const {
  if (is_over()) return std::vector<std::string>(scenarios.size());
  ChildEnd end;
  std::vector<std::string> hashes = query(uses_check_ ? Query::check : Query::run, scenarios, end);
  for (std::size_t index = 0; index < scenarios.size(); ++index) {
    if (!hashes[index].empty() || is_over()) continue;
    hashes[index] = query(Query::run, scenarios.subspan(index, 1), end).front();
    if (hashes[index].empty() && !is_over()) hashes[index] = end_text(end, limit_s_);
  }
  return hashes;
}

double OtherProgram::left_s() const {
  if (!deadline_) return limit_s_;
  return std::clamp(std::chrono::duration<double>(*deadline_ - SteadyClock::now()).count(), 0.0, limit_s_);
}

// The hash of each; empty where it printed none.
std::vector<std::string> OtherProgram::query(Query command, std::span<const Scenario> scenarios,
                                             ChildEnd& end) const {
  const TemporaryFolder folder;
  const std::string inputs = folder.path() + "/in";
  std::filesystem::create_directory(inputs);
  std::vector<std::string> paths;
  Expect another_hash;
  another_hash.state_hash = kNoHash;
  for (Scenario scenario : scenarios) {
    scenario.expect = command == Query::check ? std::optional(another_hash) : std::nullopt;
    paths.push_back(folder.write("in/" + scenario.name + ".json", scenario_file_text(scenario)));
  }
  end = command == Query::run
            ? run_child({program_, "run", inputs, "--json", "-o", folder.path() + "/out/"}, {}, left_s(),
                        kOutBytesMax)
            : run_child({program_, "check", inputs, "--json", "--jobs", "1"}, {}, left_s(), kOutBytesMax);
  Hashes printed = hashes_in(parsed(end.out));
  std::vector<std::string> hashes;
  for (const std::string& path : paths) hashes.push_back(printed[path]);
  return hashes;
}

}  // namespace hyrax
