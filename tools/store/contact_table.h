// Contacts on their way into a file: they arrive one by one, and some end long after they began.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim/trajectory/contact.h"
#include "tools/store/hdf5.h"

namespace hyrax {

/// Holds up to a batch of contacts; only more than that makes the datasets grow, in chunks.
class ContactTable {
 public:
  static constexpr std::size_t kBatch = 4096;

  /// @param group the open group /contacts.
  explicit ContactTable(hid_t group) : group_(group) {}

  /// Each returns false where the file could not be written.
  [[nodiscard]] bool append(const Contact& contact);
  [[nodiscard]] bool set_last_step(std::int64_t index, std::int64_t last_step);
  [[nodiscard]] bool finish();
  void close() { datasets_.clear(); }

 private:
  [[nodiscard]] bool make_datasets(bool is_growing);
  [[nodiscard]] bool flush();
  [[nodiscard]] bool describe() const;

  hid_t group_;
  std::vector<Contact> batch_;
  std::int64_t flushed_ = 0;
  std::vector<h5::Handle> datasets_;  // step, last_step, wall, then kContactColumns.
};

}  // namespace hyrax
