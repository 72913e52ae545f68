// Random flings beside others that start almost as they do: when their contacts part.
#include <array>
#include <utility>
#include <vector>

#include "sim/study/hard_cases/hard_case.h"
#include "sim/study/methods/many_flings.h"
#include "sim/study/methods/method_errors.h"
#include "sim/study/study_table.h"

namespace hyrax {
namespace {

struct Parting {
  std::string laws;
  double part = 0.0;  // Of each value of the start: so far apart they start.
  Share parted = {};
  std::vector<double> after_s = {}, contacts = {};  // Of those that part.
};

Parting parting_of(const std::string& laws, const Core& core, double part, double until_s) {
  constexpr double kRate_hz = 60.0;
  constexpr std::int64_t kFlings = 100;
  const ManyFlings flings({FixedRate{kRate_hz}, {}}, until_s, kFlings);
  Parting parting{laws, part};
  for (std::int64_t number = 0; number < kFlings; ++number) {
    State now = flings.start(number), beside = now;
    for (double State::*const value : {&State::x_px, &State::y_px, &State::vx_px_per_s, &State::vy_px_per_s})
      beside.*value *= 1.0 - part;
    std::array<bool, kWalls.size()> met = {}, met_beside = {};
    std::int64_t frame = 0, contacts = 0;
    for (; frame < flings.frames() && met == met_beside; ++frame) {
      now = core.step(now, 1.0 / kRate_hz, kDesktop);
      beside = core.step(beside, 1.0 / kRate_hz, kDesktop);
      met_beside = walls_of(beside, kDesktop);
      const auto before = std::exchange(met, walls_of(now, kDesktop));
      for (std::size_t wall = 0; wall < met.size(); ++wall) contacts += met[wall] && !before[wall] ? 1 : 0;
    }
    parting.parted.add(met != met_beside);
    if (met == met_beside) continue;
    parting.after_s.push_back(static_cast<double>(frame) / kRate_hz);
    parting.contacts.push_back(static_cast<double>(contacts));
  }
  return parting;
}

std::string median_text(const std::vector<double>& values, int decimals) {
  if (values.empty()) return "-";
  const MedianEstimate median = median_of(values);
  return interval_text(median.median, median.low, median.high, decimals);
}

}  // namespace

Table parting_table(const Core& core) {
  std::vector<Parting> partings;
  for (const bool is_lossless : {false, true})
    for (const double part : {0x1p-52, 1e-9, 1e-6, 1e-3})
      partings.push_back(is_lossless ? parting_of("without losses, 600 s", lossless(core), part, 600.0)
                                     : parting_of("the core's, 16 s", core, part, 16.0));
  using P = const Parting&;
  return StudyTable("partings", "when contacts of two flings part that start almost alike", partings)
      .add("laws", "", "laws, and how long they are played", &Parting::laws)
      .add("apart", "1", "by which part of each value of the start", &Parting::part, 2)
      .add("contacts_part_in", "", "share, 95 % interval",
           [](P each) { return share_text(each.parted, "flings"); })
      .add("after,_s", "", "median, 95 % interval", [](P each) { return median_text(each.after_s, 1); })
      .add("after_contacts", "", "likewise", [](P each) { return median_text(each.contacts, 0); });
}

}  // namespace hyrax
