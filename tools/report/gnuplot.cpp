#include "tools/report/gnuplot.h"

#include <sstream>

#include "tools/files/atomic_file.h"
#include "tools/files/child_process.h"
#include "tools/report/svg.h"

namespace hyrax {
namespace {

// gnuplot's words in one line.
std::string in_one_line(const std::string& text) {
  std::string line;
  std::istringstream words(text);
  for (std::string word; words >> word;) line += (line.empty() ? "" : " ") + word;
  return line;
}

ChildEnd run_gnuplot(const std::string& path, const std::string& script) {
  try {
    return run_child({"gnuplot", "--default-settings"}, script, std::nullopt);
  } catch (const CannotStart& error) {
    throw Failure(ExitCode::cannot_access,
                  path + ": cannot be drawn: " +
                      (error.is_missing()
                           ? "gnuplot is not installed; `apt-get install gnuplot-nox`, or tools/run does it"
                           : error.what()));
  }
}

}  // namespace

void draw_figure(const std::string& path, const std::string& script) {
  AtomicFile file(path);
  const ChildEnd end = run_gnuplot(path, script);
  if (end.exit_code != 0)
    throw Failure(ExitCode::program_fault, path + ": cannot be drawn: gnuplot says: " + in_one_line(end.err));
  if (end.out.find("</svg>") == end.out.npos)
    throw Failure(ExitCode::program_fault, path + ": cannot be drawn: gnuplot wrote no complete picture");
  file.write(finished_svg(end.out, script));
  file.commit();
}

}  // namespace hyrax
