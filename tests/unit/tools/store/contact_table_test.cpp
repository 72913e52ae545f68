// Contacts that arrive one by one and end late, few and many.
#include "tools/store/trajectory_parts.h"

#include <gtest/gtest.h>

#include "tests/unit/tools/store/stored_flings.h"

namespace hyrax {
namespace {

constexpr auto kBatch = static_cast<std::int64_t>(ContactTable::kBatch);

Contact contact_number(std::int64_t number) {
  const auto value = static_cast<double>(number);
  return {.step = 2 * number + 1,
          .last_step = 2 * number + 1,
          .wall = kWalls[static_cast<std::size_t>(number % 4)],
          .t_s = value / 8.0,
          .x_px = value,
          .y_px = -value,
          .vx_before_px_per_s = value + 0.25,
          .vy_before_px_per_s = value + 0.5,
          .vx_after_px_per_s = value - 0.25,
          .vy_after_px_per_s = value - 0.5,
          .overshoot_px = value * 3.0};
}

class Contacts : public testing::Test {
 protected:
  // A file with so many contacts, of which some are extended after later ones were written.
  std::vector<Contact> write(std::int64_t count, const std::vector<std::int64_t>& lasting) {
    std::vector<Contact> contacts;
    TrajectoryWriter writer(path_, fling_at(60.0, 0), 0);
    Columns start;
    start.append(Row{});
    writer.rows(start);
    for (std::int64_t number = 0; number < count; ++number) {
      contacts.push_back(contact_number(number));
      writer.contact_began(contacts.back());
    }
    for (const std::int64_t index : lasting) {
      contacts[static_cast<std::size_t>(index)].last_step += 1'000'000;
      writer.contact_ended(index, contacts[static_cast<std::size_t>(index)].last_step);
    }
    writer.finish({fling_at(60.0, 0), 0, "hyrax-physics/1", std::string(32, '0')}, {}, count);
    return contacts;
  }

  const TempFolder folder_;
  const std::string path_ = folder_.at("contacts.h5");
};

TEST_F(Contacts, AreKeptFewOrMany) {
  for (const std::int64_t count : {std::int64_t{0}, std::int64_t{1}, kBatch - 1, kBatch, kBatch + 1}) {
    const std::vector<Contact> contacts = write(count, {});
    EXPECT_TRUE(same_contacts(TrajectoryFile(path_).contacts(), contacts)) << count;
    EXPECT_EQ(TrajectoryFile(path_).contacts_total(), count);
    EXPECT_TRUE(TrajectoryFile(path_).inputs().empty());
  }
}

TEST_F(Contacts, MayEndAfterTheyWereWrittenAndAreTheSameBytesEachTime) {
  const auto write_some = [&] {
    return write(2 * kBatch + 10, {0, kBatch - 1, kBatch, 2 * kBatch - 1, 2 * kBatch, 2 * kBatch + 9});
  };
  const std::vector<Contact> contacts = write_some();
  EXPECT_TRUE(same_contacts(TrajectoryFile(path_).contacts(), contacts));
  const std::string first = bytes_of(path_);
  write_some();
  EXPECT_TRUE(first == bytes_of(path_));
}

}  // namespace
}  // namespace hyrax
