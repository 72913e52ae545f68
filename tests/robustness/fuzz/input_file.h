// A fuzzer's input as a file, in memory (/dev/shm) where possible.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include <stdlib.h>
#include <unistd.h>

#include "tests/robustness/fuzz/fuzz_target.h"

namespace hyrax {

class InputFile {
 public:
  explicit InputFile(std::string_view bytes) {
    const int descriptor = mkstemp(path_.data());
    hold(descriptor >= 0 &&
             ::write(descriptor, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size()),
         "an input can be written");
    close(descriptor);
  }
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;
  ~InputFile() { unlink(path_.c_str()); }

  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_ =
      std::string(std::filesystem::is_directory("/dev/shm") ? "/dev/shm" : "/tmp") + "/hyrax-fuzz-XXXXXX";
};

}  // namespace hyrax
