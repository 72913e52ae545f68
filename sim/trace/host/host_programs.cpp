// The main programs of the build's two host programs: one records a step, one holds the compiled core to it.
#include <fstream>
#include <iterator>

#include "sim/trace/host/allowed.h"
#include "sim/trace/host/compiled_core.h"
#include "sim/trace/host/described_explorer.h"
#include "sim/trace/host/explorer.h"
#include "sim/trace/host/limits.h"
#include "sim/trace/listing_step.h"
#include "sim/trace/step_text.h"

namespace hyrax::trace {

namespace {

std::string text_of(const char* path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

int record_main(const auto& trace, int argument_count, char** arguments) {
  if (argument_count != 3 && argument_count != 7) return 2;
  limit_process(arguments[2]);
  if (argument_count == 7) {
    const std::string compiled = text_of(arguments[4]), traced = text_of(arguments[5]),
                      symbols = text_of(arguments[6]);
    if (const auto why = why_not_allowed({arguments[3], compiled, traced, symbols})) stop(why->c_str());
  }
  const std::string text = step_text(canonical(trace()));
  std::ofstream(arguments[1], std::ios::binary) << text;
  return 0;
}

}  // namespace

int record_main(const TracedCore& core, int argument_count, char** arguments) {
  return record_main([&core] { return trace_core(core); }, argument_count, arguments);
}

int record_main(const DescribedCalls& core, int argument_count, char** arguments) {
  return record_main([&core] { return trace_described(core); }, argument_count, arguments);
}

int check_main(const CompiledCore& core, const std::optional<Constants>& constants, int argument_count,
               char** arguments) {
  if (argument_count != 4) return 2;
  limit_process(arguments[2]);
  const std::optional<TracedStep> step = read_step(text_of(arguments[1]));
  std::optional<std::string> why = "its text cannot be read";
  if (step) why = step_that_differs(core, *step);
  if (why)
    std::ofstream(arguments[2], std::ios::binary)
        << "the traced step does not give the compiled core's bits: " << *why;
  else if (const auto paper = match_paper(*step).constants;
           constants && paper && same_bits(*constants, *paper))
    std::ofstream(arguments[3], std::ios::binary) << "the paper's step\n";
  return 0;
}

}  // namespace hyrax::trace
