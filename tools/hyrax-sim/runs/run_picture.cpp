#include "tools/hyrax-sim/runs/run_picture.h"

#include <algorithm>

#include "sim/replay/replay.h"
#include "tools/report/run_figure.h"

namespace hyrax {
namespace {

constexpr std::int64_t kRowsMax = 50'000;
constexpr std::size_t kContactsMax = 100;

// Takes every K-th row after a step, and the first contacts.
class PictureSink : public RowSink {
 public:
  PictureSink(std::int64_t rows_every, std::int64_t after_step)
      : rows_every_(rows_every), after_step_(after_step) {}

  [[nodiscard]] Wants wants() const override { return {.rows_every = rows_every_, .contacts = true}; }
  void rows(const Columns& batch) override {
    for (std::size_t index = 0; index < batch.size(); ++index)
      if (batch.step[index] > after_step_) taken.append(batch.row(index));
  }
  void contact_began(const Contact& contact) override {
    if (contacts.size() < kContactsMax) contacts.push_back(contact);
  }
  void contact_ended(std::int64_t index, std::int64_t last_step) override {
    if (static_cast<std::size_t>(index) < contacts.size())
      contacts[static_cast<std::size_t>(index)].last_step = last_step;
  }

  Columns taken;
  std::vector<Contact> contacts;

 private:
  std::int64_t rows_every_;
  std::int64_t after_step_;
};

}  // namespace

void draw_run(const std::string& path, const Scenario& scenario) {
  PictureSink sink(1, -1);
  Replay beginning(scenario, sink);
  const std::int64_t steps = beginning.steps();
  beginning.play_to(std::min(steps, kRowsMax));
  WallCounts contacts = beginning.finish().contacts;
  if (steps > kRowsMax) {
    PictureSink rest(1 + steps / kRowsMax, kRowsMax);
    contacts = replay(scenario, rest).contacts;
    for (std::size_t index = 0; index < rest.taken.size(); ++index) sink.taken.append(rest.taken.row(index));
    sink.contacts = std::move(rest.contacts);
  }
  draw_run_figure(path, scenario, sink.taken, sink.contacts, contacts);
}

}  // namespace hyrax
