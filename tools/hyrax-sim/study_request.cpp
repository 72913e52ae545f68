#include "tools/hyrax-sim/study_request.h"

#include <charconv>
#include <cmath>

#include "tools/files/unknown_word.h"

namespace hyrax {

void declare_study(Options& options, StudyArguments& arguments, const std::string& study_list) {
  options.files(arguments.words, {"NAME [SCENARIO]", "", "the study, and scenarios for it:\n" + study_list},
                1, -1);
  options.text(
      arguments.folder,
      {"-o,--output", "DIR", "folder of NAME.h5, NAME.csv and the figures; the current one if left out"});
  options.flag(arguments.is_quick, {"--quick", "", "a smaller study, in seconds"});
  options.flag(arguments.is_gate, {"--gate", "", "exit 1 where something that the study holds is broken"});
  options.text(arguments.expect_file, {"--expect", "FILE", "paper: verdicts to hold it to, for --gate"});
  options.text(arguments.within, {"--within", "LENGTH", "needs: the tolerance, as 1px"});
  options.flag(arguments.is_json, {"--json", "", "one JSON document instead of the verdict"});
  options.flag(arguments.draws_nothing, {"--no-figures", "", "draws nothing (figures need gnuplot)"});
}

const StudyKind& find_study(const std::vector<StudyKind>& kinds, const std::string& name) {
  std::vector<std::string_view> names;
  for (const StudyKind& kind : kinds) {
    if (kind.name == name) return kind;
    names.push_back(kind.name);
  }
  throw Failure(ExitCode::bad_input, "hyrax-sim study: " + unknown_word("study", name, names));
}

StudyRequest study_request(const StudyKind& kind, const StudyArguments& arguments) {
  const auto refuse = [&](const std::string& what) {
    throw Failure(ExitCode::bad_input, "hyrax-sim study " + kind.name + ": " + what +
                                           "; `hyrax-sim study --help` tells what it takes");
  };
  StudyRequest request;
  request.scenarios.assign(arguments.words.begin() + 1, arguments.words.end());
  if (!request.scenarios.empty() && !kind.takes_scenarios)
    refuse("takes no scenarios, '" + request.scenarios.front() + "' is given");
  if (!arguments.expect_file.empty() && !kind.takes_expect) refuse("has no use for --expect");
  if (kind.takes_expect && arguments.is_gate && arguments.expect_file.empty())
    refuse("--gate needs --expect FILE, the verdicts to hold it to");
  if (!arguments.within.empty() && !kind.takes_within) refuse("has no use for --within");
  request.is_quick = arguments.is_quick;
  request.expect_file = arguments.expect_file;
  if (!arguments.within.empty())
    request.within_px = parse_length_px(arguments.within, "hyrax-sim study " + kind.name + ": --within");
  return request;
}

double parse_length_px(const std::string& text, const std::string& place) {
  double length_px = 0.0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, length_px);
  const std::string unit(rest, end);
  if (error != std::errc() || !(unit.empty() || unit == "px" || unit == " px") || !std::isfinite(length_px) ||
      length_px < 0.0)
    throw Failure(ExitCode::bad_input, place + ": must be a length of at least 0, as 1px, is '" + text + "'");
  return length_px;
}

}  // namespace hyrax
