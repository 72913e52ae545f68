#include "sim/trace/host/limits.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <exception>
#include <new>

#include "sim/trace/host/recorder.h"

namespace hyrax::trace {
namespace {

std::array<char, 4096> why_path{};

void end_by_exception() {
  try {
    std::rethrow_exception(std::current_exception());
  } catch (const std::bad_alloc&) {
    end_because("over its limits: more than 1 GB of memory");
  } catch (...) {
    end_because("over its limits: throws an exception");
  }
}

}  // namespace

// Allocates nothing: a signal may call it.
void end_because(const char* why) {
  const int file = open(why_path.data(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  [[maybe_unused]] const auto written = write(file, why, static_cast<unsigned>(std::strlen(why)));
  _exit(0);
}

void limit_process(const std::string& why_file, unsigned cpu_s_max) {
  if (why_file.size() >= why_path.size()) end_because("over its limits: a path of more than 4,095 bytes");
  std::strcpy(why_path.data(), why_file.c_str());
  set_stop_handler([](const char* why) { end_because(why); });
  std::set_terminate(end_by_exception);
  limit_resources(cpu_s_max);
}

}  // namespace hyrax::trace
