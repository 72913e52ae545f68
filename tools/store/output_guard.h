// Which files a command may write: none of its inputs, no golden file and no scenario.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hyrax {

/// Every output of a command passes admit() before anything is written. Files are compared by device and
/// inode, so that links, hard links and `..` make no difference. An output may not be
///   an input, or an input's golden file;
///   in a golden folder: one given by --golden, one beside a folder `scenarios`, or that of an input;
///   an existing scenario: JSON text with the format's name, or a *.json in a folder `scenarios`;
///   an output that was admitted before.
class OutputGuard {
 public:
  /// @param inputs the files that the command reads. @param golden_folder empty if none was given.
  explicit OutputGuard(const std::vector<std::string>& inputs, const std::string& golden_folder = "");

  /// @param option for the message, as "hyrax-sim run: --figure".
  /// @param suffixes one of which its name must end in; empty: any name.
  /// ERRORS: Failure(bad_input) "OPTION: would overwrite ... (found PATH); ...".
  void admit(const std::string& option, const std::string& path,
             const std::vector<std::string_view>& suffixes = {});

  /// The same for a file whose folder exists.
  /// ERRORS: also Failure(cannot_access) "PATH: cannot be written: ..." if the folder does not exist.
  void admit_file(const std::string& option, const std::string& path,
                  const std::vector<std::string_view>& suffixes = {});

  /// The same as admit_file for a scenario file: it may replace a scenario, if that is forced.
  /// ERRORS: also Failure(bad_input) "PATH: exists; ...".
  void admit_scenario(const std::string& option, const std::string& path, bool is_forced,
                      const std::vector<std::string_view>& suffixes = {});

  /// The same for a golden file that is written on purpose; it may be admitted several times.
  void admit_golden(const std::string& option, const std::string& path) const;

 private:
  using Identity = std::pair<std::uintmax_t, std::uintmax_t>;
  struct Route;

  [[nodiscard]] Route route_to(const std::string& path) const;
  void admit_any(const std::string& option, const std::string& path,
                 const std::vector<std::string_view>& suffixes);
  void refuse_inputs(const std::string& option, const std::string& path) const;
  void refuse_scenarios(const std::string& option, const std::string& path) const;

  std::set<Identity> inputs_;
  std::set<Identity> golden_files_;
  std::set<std::string> golden_folders_;  // Their paths without links.
  std::set<std::string> outputs_;
};

/// Throws Failure(cannot_access) where the file cannot be written, as far as can be known without writing.
void require_writable(const std::string& path);

/// Makes the folder of outputs, and those above it, unless it is there.
/// ERRORS: Failure(cannot_access) "PATH: WHAT: REASON".
void make_folder(const std::string& path, const std::string& what = "cannot create the folder");

}  // namespace hyrax
