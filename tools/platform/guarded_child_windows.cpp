#include "tools/platform/guarded_child.h"

#include <utility>

#include <windows.h>

#include "tools/files/failure.h"
#include "tools/platform/wide_text.h"

namespace hyrax {
namespace {

struct HandleClosed {
  void operator()(HANDLE handle) const { CloseHandle(handle); }
};
using Owned = std::unique_ptr<void, HandleClosed>;

// As the C library of a program takes its command line apart.
std::wstring quoted(const std::string& argument) {
  std::wstring text = L"\"";
  std::size_t backslashes = 0;
  for (const wchar_t c : to_wide(argument)) {
    if (c == L'"') text.append(backslashes + 1, L'\\');
    backslashes = c == L'\\' ? backslashes + 1 : 0;
    text += c;
  }
  return text.append(backslashes, L'\\') + L'"';
}

// A process of this job ends when the last handle of the job is closed, also by the end of a killed process.
Owned make_job() {
  Owned job(CreateJobObjectW(nullptr, nullptr));
  JOBOBJECT_EXTENDED_LIMIT_INFORMATION limits{};
  limits.BasicLimitInformation.LimitFlags = JOB_OBJECT_LIMIT_KILL_ON_JOB_CLOSE;
  SetInformationJobObject(job.get(), JobObjectExtendedLimitInformation, &limits, sizeof limits);
  return job;
}

// Of a program that this one starts: what it prints, then its end.
class Program {
 public:
  Program(const std::wstring& file, const std::vector<std::string>& arguments, bool is_silent)
      : job_(make_job()) {
    SECURITY_ATTRIBUTES inherited{sizeof inherited, nullptr, TRUE};
    HANDLE read_end = nullptr;
    HANDLE write_end = nullptr;
    if (CreatePipe(&read_end, &write_end, &inherited, 0) == 0) return;
    printed_.reset(read_end);
    const Owned child_end(write_end);
    SetHandleInformation(read_end, HANDLE_FLAG_INHERIT, 0);
    const Owned nowhere(CreateFileW(L"NUL", GENERIC_WRITE, FILE_SHARE_READ | FILE_SHARE_WRITE, &inherited,
                                    OPEN_EXISTING, FILE_ATTRIBUTE_NORMAL, nullptr));
    std::wstring line;
    for (const std::string& argument : arguments)
      line.append(line.empty() ? L"" : L" ").append(quoted(argument));
    STARTUPINFOW start{};
    start.cb = sizeof start;
    start.dwFlags = STARTF_USESTDHANDLES;
    start.hStdInput = GetStdHandle(STD_INPUT_HANDLE);
    start.hStdOutput = write_end;
    start.hStdError = is_silent ? nowhere.get() : GetStdHandle(STD_ERROR_HANDLE);
    PROCESS_INFORMATION made{};
    if (CreateProcessW(file.c_str(), line.data(), nullptr, nullptr, TRUE, CREATE_SUSPENDED, nullptr, nullptr,
                       &start, &made) == 0)
      return;
    process_.reset(made.hProcess);
    const Owned thread(made.hThread);
    AssignProcessToJobObject(job_.get(), made.hProcess);
    ResumeThread(made.hThread);
  }

  [[nodiscard]] bool has_started() const { return process_ != nullptr; }

  // What it printed, if its exit code is 0.
  [[nodiscard]] std::optional<std::string> result() const {
    std::string all;
    char buffer[1 << 12];
    for (DWORD count = 0; ReadFile(printed_.get(), buffer, sizeof buffer, &count, nullptr) != 0 && count > 0;)
      all.append(buffer, count);
    DWORD exit_code = 1;
    WaitForSingleObject(process_.get(), INFINITE);
    GetExitCodeProcess(process_.get(), &exit_code);
    return exit_code == 0 ? std::optional(std::move(all)) : std::nullopt;
  }

 private:
  Owned job_;
  Owned printed_;
  Owned process_;
};

constexpr DWORD kPathMax = 32'768;

std::wstring own_file() {
  std::wstring file(kPathMax, 0);
  file.resize(GetModuleFileNameW(nullptr, file.data(), kPathMax));
  return file;
}

// In the folders of PATH alone: the current one may be another person's.
std::wstring file_in_path(const std::string& name) {
  const wchar_t* const folders = _wgetenv(L"PATH");
  std::wstring file(kPathMax, 0);
  file.resize(folders == nullptr
                  ? 0
                  : SearchPathW(folders, to_wide(name).c_str(), L".exe", kPathMax, file.data(), nullptr));
  return file;
}

}  // namespace

bool WorkEnd::is_timed_out() const { return false; }

std::string WorkEnd::signal_text() const { return {}; }

bool guards_work() { return false; }

WorkEnd in_child(const std::string& /*what*/, const ChildLimits& /*limits*/,
                 const std::function<std::string()>& work) {
  return {.result = work(), .signal = 0};
}

WorkEnd in_new_process(const std::string& what, std::vector<std::string> arguments) {
  const Program program(own_file(), arguments, false);
  if (!program.has_started())
    throw Failure(ExitCode::cannot_access, what + ": cannot create a child process");
  return {.result = program.result(), .signal = 0};
}

std::optional<std::string> printed_by(std::vector<std::string> words) {
  const std::wstring file = file_in_path(words.front());
  if (file.empty()) return std::nullopt;
  const Program program(file, words, true);
  return program.has_started() ? program.result() : std::nullopt;
}

void limit_wall_time(double /*limit_s*/) {}

}  // namespace hyrax
