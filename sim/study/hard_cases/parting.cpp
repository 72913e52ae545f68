// Random flings beside others that start almost as they do: when their contacts part.
#include <array>
#include <cmath>
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
  std::string apart;  // Of each value of the start, towards 0.
  Share parted = {};
  std::vector<double> after_s = {}, contacts = {};  // Of those that part.
};

Parting parting_of(const std::string& laws, const Core& core, double part, double until_s) {
  constexpr std::int64_t kFlings = 100;
  constexpr double kFrame_s = 1.0 / 60.0;
  Parting parting{laws, part == 0.0 ? "an ulp" : fmt::format("{:g}", part)};
  const ManyFlings flings({FixedRate{60.0}, {}}, until_s, kFlings);
  for (std::int64_t number = 0; number < kFlings; ++number) {
    State now = flings.start(number), beside = now;
    for (double State::*const value : {&State::x_px, &State::y_px, &State::vx_px_per_s, &State::vy_px_per_s})
      beside.*value = std::nextafter(beside.*value * (1.0 - part), 0.0);
    std::array<bool, kWalls.size()> met = {}, met_beside = {};
    std::int64_t frame = 0, contacts = 0;
    for (; frame < flings.frames() && met == met_beside; ++frame) {
      now = core.step(now, kFrame_s, kDesktop);
      beside = core.step(beside, kFrame_s, kDesktop);
      met_beside = walls_of(beside, kDesktop);
      const auto before = std::exchange(met, walls_of(now, kDesktop));
      for (std::size_t wall = 0; wall < met.size(); ++wall) contacts += met[wall] && !before[wall] ? 1 : 0;
    }
    parting.parted.add(met != met_beside);
    if (met == met_beside) continue;
    parting.after_s.push_back(static_cast<double>(frame) * kFrame_s);
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
  for (const double part : {0.0, 1e-9, 1e-6, 1e-3})
    partings.push_back(parting_of("the core's, 16 s", core, part, 16.0));
  for (const double part : {0.0, 1e-9, 1e-6, 1e-3})
    partings.push_back(parting_of("without losses, 600 s", lossless(core), part, 600.0));
  return StudyTable("partings", "when contacts of two flings part that start almost alike", partings)
      .add("laws", "", "laws, and how long they are played", &Parting::laws)
      .add("apart", "", "of each value of the start", &Parting::apart)
      .add("contacts_part_in", "", "share with its 95 % interval",
           [](const Parting& parting) { return share_text(parting.parted, "flings"); })
      .add("after,_s", "", "median with its 95 % interval, of those that part",
           [](const Parting& parting) { return median_text(parting.after_s, 1); })
      .add("after_contacts", "", "likewise",
           [](const Parting& parting) { return median_text(parting.contacts, 0); });
}

}  // namespace hyrax
