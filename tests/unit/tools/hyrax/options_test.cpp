// What hyrax.exe is asked by options.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "tests/unit/tools/files/refusal.h"
#include "tools/hyrax/options.h"

namespace hyrax {
namespace {

TEST(PetOptions, MayBeLeftOutAndAcceptTheirValueAfterASpaceOrAnEqualsSign) {
  const PetOptions none = parse_options({});
  EXPECT_FALSE(none.record_path || none.replay_path || none.log_path || none.seconds);
  EXPECT_FALSE(none.only_exits || none.wants_help || none.wants_version);
  const PetOptions options = parse_options({"--record", "a b.json", "--log=run.log", "--seconds", "2.5"});
  EXPECT_EQ(options.record_path, "a b.json");
  EXPECT_EQ(options.log_path, "run.log");
  EXPECT_EQ(options.seconds, 2.5);
  const PetOptions of_replay = parse_options({"--exit", "--replay", "x.json"});
  EXPECT_EQ(of_replay.replay_path, "x.json");
  EXPECT_TRUE(of_replay.only_exits);
  EXPECT_EQ(parse_options({"dragged onto it.json", "--exit"}).replay_path, "dragged onto it.json");
  for (const std::string option : {"--help", "-h", "/?", "--version"}) {
    const PetOptions asked = parse_options({option});
    EXPECT_EQ(asked.wants_version, option == "--version");
    EXPECT_EQ(asked.wants_help, option != "--version") << option;
  }
  EXPECT_EQ(parse_options({"--seconds=0"}).seconds, 0.0);
  EXPECT_EQ(parse_options({"--seconds", "1e9"}).seconds, 1e9);
}

TEST(PetOptions, OfOtherNamesAndValuesAndTogetherWithOthersAreRefused) {
  using Arguments = std::vector<std::string>;
  for (const auto& [arguments, says] :
       {std::pair{Arguments{"--recrod", "x"},
                  "hyrax: unknown option (found --recrod); allowed: --record, --replay, --log, --seconds, "
                  "--exit, --help, --version (did you mean --record?); see `hyrax --help`"},
        {Arguments{"-x.json"}, "unknown option (found -x.json)"},
        {Arguments{""}, "unknown option (found )"},
        {Arguments{"x.json", "y.json"}, "--replay: given twice"},
        {Arguments{"x.json", "--record", "y.json"}, "--record is not allowed with --replay:"},
        {Arguments{"--record"}, "--record needs a value"},
        {Arguments{"--seconds="}, "--seconds needs a value"},
        {Arguments{"--exit=yes"}, "--exit takes no value (found yes)"},
        {Arguments{"--exit"}, "--exit needs --replay FILE"},
        {Arguments{"--exit", "--replay", "a", "--log", "b"},
         "--exit is not allowed with --log or --seconds:"},
        {Arguments{"--exit", "--replay", "a", "--seconds", "1"}, "--exit is not allowed with --log"},
        {Arguments{"--record", "a", "--record=b"}, "--record: given twice"},
        {Arguments{"--record", "a", "--log", "a"}, "--record and --log need different files (found a)"},
        {Arguments{"--seconds", "soon"}, "--seconds must be a number 0 .. 1e9 (found soon"},
        {Arguments{"--seconds", "-1"}, "(found -1"},
        {Arguments{"--seconds", "nan"}, "(found nan"},
        {Arguments{"--seconds", "1e10"}, "(found 1e10"},
        {Arguments{"--seconds", "5s"}, "(found 5s"},
        {Arguments{"--record", "a", "--replay", "b"}, "--record is not allowed with --replay:"}}) {
    const std::string said = refusal_of([&given = arguments] { static_cast<void>(parse_options(given)); });
    EXPECT_NE(said.find(says), std::string::npos) << said;
  }
}

}  // namespace
}  // namespace hyrax
