// Recorded rows and contacts as columns, the way files hold them.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "sim/result/table.h"
#include "sim/trajectory/row.h"

namespace hyrax {

/// A batch of rows; all vectors have the same length.
struct Columns {
  std::vector<std::int64_t> step;
  std::vector<double> t_s, dt_s, x_px, y_px, vx_px_per_s, vy_px_per_s;
  std::vector<std::uint8_t> contact;

  [[nodiscard]] std::size_t size() const { return step.size(); }

  void reserve(std::size_t rows) {
    for_each([rows](auto& column) { column.reserve(rows); });
  }
  void clear() {
    for_each([](auto& column) { column.clear(); });
  }
  void append(const Row& row) {
    step.push_back(row.step);
    t_s.push_back(row.t_s);
    dt_s.push_back(row.dt_s);
    x_px.push_back(row.x_px);
    y_px.push_back(row.y_px);
    vx_px_per_s.push_back(row.vx_px_per_s);
    vy_px_per_s.push_back(row.vy_px_per_s);
    contact.push_back(row.contact);
  }
  /// REQUIRES: index < size().
  [[nodiscard]] Row row(std::size_t index) const {
    return {step[index], t_s[index],         dt_s[index],        x_px[index],
            y_px[index], vx_px_per_s[index], vy_px_per_s[index], contact[index]};
  }

 private:
  template <class Visit>
  void for_each(const Visit& visit) {
    visit(step);
    visit(t_s);
    visit(dt_s);
    visit(x_px);
    visit(y_px);
    visit(vx_px_per_s);
    visit(vy_px_per_s);
    visit(contact);
  }
};

/// A column of doubles, with its place in a batch of rows.
/// A new one is added to Row and Columns, and here: every reader and writer of rows uses this list.
using RowColumn = ColumnOf<Row, std::vector<double> Columns::*>;

inline constexpr std::array<RowColumn, 6> kRowColumns = {{
    {"t", "s", "time since the start", &Row::t_s, "", &Columns::t_s},
    {"dt", "s", "duration of the frame", &Row::dt_s, "", &Columns::dt_s},
    {"x", "px", "left edge of the sprite, to the right", &Row::x_px, "", &Columns::x_px},
    {"y", "px", "top edge of the sprite, downwards", &Row::y_px, "", &Columns::y_px},
    {"vx", "px/s", "velocity to the right", &Row::vx_px_per_s, "", &Columns::vx_px_per_s},
    {"vy", "px/s", "velocity downwards", &Row::vy_px_per_s, "", &Columns::vy_px_per_s},
}};

/// The flags of a row's contact byte.
inline constexpr std::array<std::uint8_t, 5> kContactFlags = {1, 2, 4, 8, kRestBit};
inline constexpr std::array<std::string_view, 5> kContactFlagNames = {"left", "right", "top", "ground",
                                                                      "rest"};

using ContactColumn = ColumnOf<Contact>;
inline constexpr ContactColumn kContactColumns[] = {
    {"step", "", "first clamped row", &Contact::step},
    {"last_step", "", "last clamped row", &Contact::last_step},
    {"wall", "", "wall: 1 left, 2 right, 4 top, 8 ground",
     ContactColumn::Code{[](const Contact& c) { return static_cast<std::uint8_t>(c.wall); },
                         {kWallNames, true}}},
    {"t", "s", "time of the first clamped row", &Contact::t_s},
    {"x", "px", "left edge of the sprite", &Contact::x_px},
    {"y", "px", "top edge of the sprite", &Contact::y_px},
    {"vx_before", "px/s", "velocity to the right as it met the wall", &Contact::vx_before_px_per_s},
    {"vy_before", "px/s", "velocity downwards as it met the wall", &Contact::vy_before_px_per_s},
    {"vx_after", "px/s", "velocity to the right after it", &Contact::vx_after_px_per_s},
    {"vy_after", "px/s", "velocity downwards after it", &Contact::vy_after_px_per_s},
    {"overshoot", "px", "how far past the wall the unclamped position was", &Contact::overshoot_px},
};
/// Those behind step, last step and wall.
inline constexpr std::span kContactQuantities = std::span(kContactColumns).subspan<3>();

}  // namespace hyrax
