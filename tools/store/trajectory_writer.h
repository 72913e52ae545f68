// Writes a run into a `hyrax-trajectory/1` file as it is played.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sim/trajectory/row_sink.h"
#include "tools/files/atomic_file.h"
#include "tools/store/contact_table.h"
#include "tools/store/file_head.h"
#include "tools/store/row_table.h"

namespace hyrax {

/// Takes the rows that the scenario's record.every asks for, and all contacts. Memory does not
/// grow with the run. The file stands in its place only after finish().
/// ERRORS: every call may throw Failure(cannot_access) "PATH: cannot be written: REASON".
class TrajectoryWriter : public RowSink {
 public:
  /// @param steps that will be played.
  TrajectoryWriter(const std::string& path, const Scenario& scenario, std::int64_t steps);

  [[nodiscard]] Wants wants() const override { return {.rows_every = rows_every_, .contacts = true}; }
  void rows(const Columns& batch) override;
  void contact_began(const Contact& contact) override;
  void contact_ended(std::int64_t index, std::int64_t last_step) override;

  /// For groups that are written as the run is played; whoever makes them closes them before `finish` ends.
  [[nodiscard]] hid_t file() const { return file_; }
  /// @param contacts_total of the run, handed on or not.
  /// @param write_more called, if it is set, once all else stands in the file, to add groups of its own;
  /// says whether they could be written.
  void finish(const FileHead& head, const std::vector<Input>& inputs, std::int64_t contacts_total,
              const std::function<bool(hid_t file)>& write_more = {});

  /// How many rows a run of `steps` has with every K-th and the last recorded.
  [[nodiscard]] static std::int64_t row_count(std::int64_t steps, std::int64_t every) {
    return steps / every + 1 + (steps % every != 0 ? 1 : 0);
  }

 private:
  void require(bool is_written) const;

  std::string path_;
  std::int64_t rows_every_;
  AtomicFile target_;
  h5::Handle file_;
  h5::Handle trajectory_;
  h5::Handle contacts_;
  RowTable row_table_;
  ContactTable contact_table_;
};

}  // namespace hyrax
