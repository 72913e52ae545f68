// Reads `hyrax-trajectory/1` files, and rejects damaged or incomplete ones.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

#include "sim/scenario/schedule.h"
#include "sim/trajectory/columns.h"
#include "sim/trajectory/row.h"
#include "tools/store/build_facts.h"
#include "tools/store/hdf5.h"
#include "tools/store/trajectory_format.h"

namespace hyrax {

/// One dataset of numbers, checked: of the type class (the class of Value, or an enumeration) and size of
/// Value, one axis, completely stored. Value: any number of up to 64 bits, no bool.
template <class Value>
class NumberColumn {
 public:
  /// ERRORS: Failure(bad_input) "PATH: DATASET: ...".
  NumberColumn(hid_t file, const std::string& path, const std::string& dataset,
               H5T_class_t type_class = std::is_floating_point_v<Value> ? H5T_FLOAT : H5T_INTEGER);

  [[nodiscard]] std::int64_t length() const { return length_; }
  /// Whether it is contiguous, in a common number format, so that the library decodes nothing.
  [[nodiscard]] bool is_plain() const { return is_plain_; }
  /// Elements `first` .. `first + count - 1`, in place of those in `values`. REQUIRES: 0 <= first, first +
  /// count <= length().
  void read(std::int64_t first, std::int64_t count, std::vector<Value>& values) const;

 private:
  std::string place_;
  h5::Handle dataset_;
  std::int64_t length_ = 0;
  bool is_plain_ = false;
};

/// What the files of all cores have. ERRORS: opening and reading throw Failure(cannot_access) if the file
/// cannot be read, and Failure(bad_input) "PATH: ..." if it is truncated or of another format, or if a
/// dataset is missing, of the wrong type, or of another length than its neighbours.
class RunFile {
 public:
  [[nodiscard]] const std::string& path() const { return path_; }
  /// The number of recorded rows.
  [[nodiscard]] std::int64_t row_count() const { return step_.length(); }
  [[nodiscard]] bool holds_every_row() const { return row_count() == root_.steps + 1; }
  /// The number of contacts, with those that are not recorded.
  [[nodiscard]] std::int64_t contacts_total() const;
  [[nodiscard]] bool has(const char* group) const;
  /// All of a dataset; see NumberColumn.
  template <class Value, class... TypeClass>
  [[nodiscard]] std::vector<Value> column(const std::string& dataset, TypeClass... type_class) const {
    const NumberColumn<Value> numbers(file_, path_, dataset, type_class...);
    std::vector<Value> values;
    numbers.read(0, numbers.length(), values);
    return values;
  }
  /// Throws Failure(bad_input) "PATH: SENTENCE".
  [[noreturn]] void refuse(const std::string& sentence) const;

 protected:
  enum class Parsing { off, on };  // Of the scenario.
  explicit RunFile(const std::string& path);

  [[nodiscard]] std::string text(const char* attribute) const;
  /// REQUIRES: a dataset of /trajectory.
  void require_rows(std::int64_t length, const std::string& name) const;

 private:
  [[nodiscard]] RunHead read_root() const;

  std::string path_;

 protected:
  h5::Handle file_;
  RunHead root_;  // What all have of it.
  NumberColumn<std::int64_t> step_;
};

class TrajectoryFile : public RunFile {
 public:
  using Read = std::function<void(const TrajectoryFile&)>;

  /// Opens a file of any origin, after reading it in a child process (read_isolated).
  /// @param read what the caller will read of it; the child reads the same. The child does not parse the
  /// scenario: that is this program's own code, needs no HDF5, and its cost depends on the scenario and
  /// not on the file's size.
  /// REQUIRES: as read_isolated.
  [[nodiscard]] static TrajectoryFile open(const std::string& path,
                                           const Read& read = &TrajectoryFile::read_all);
  /// Opens a file in this process only: a damaged one may crash the HDF5 library.
  explicit TrajectoryFile(const std::string& path) : TrajectoryFile(path, Parsing::on) {}

  /// The constants are the paper's where the file of a paper's model does not have them.
  [[nodiscard]] const FileHead& head() const { return head_; }
  /// Recorded rows `first` .. `first + count - 1`. REQUIRES: first + count <= row_count().
  [[nodiscard]] Columns rows(std::int64_t first, std::int64_t count) const;
  /// The same in place of other rows, whose memory is used again.
  void read_rows(std::int64_t first, std::int64_t count, Columns& rows) const;
  [[nodiscard]] std::vector<Contact> contacts() const;
  [[nodiscard]] std::uint8_t walls_of_rows() const;  ///< As StoredRun's.
  [[nodiscard]] std::vector<Input> inputs() const;
  [[nodiscard]] Provenance provenance() const { return read_provenance(file_); }

 private:
  TrajectoryFile(const std::string& path, Parsing parsing);

  void read_all() const;
  [[nodiscard]] FileHead read_head(Parsing parsing) const;
  void check_lengths() const;

  FileHead head_;
  std::vector<NumberColumn<double>> columns_;
  NumberColumn<std::uint8_t> contact_;
};

}  // namespace hyrax
