// Recorded rows as columns, the way files hold them.
#pragma once

#include <cstdint>
#include <vector>

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

}  // namespace hyrax
