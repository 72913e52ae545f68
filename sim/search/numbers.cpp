#include "sim/search/numbers.h"

#include <charconv>
#include <cmath>
#include <string_view>

namespace hyrax {
namespace {

class Collector {
 public:
  void add(double& number) { numbers_.push_back(&number); }
  void add(std::uint64_t& seed) { numbers_.push_back(&seed); }
  void add(Size& size) {
    numbers_.push_back(&size.width_px);
    numbers_.push_back(&size.height_px);
  }
  void add(Position& at) {
    add(at.x_px);
    add(at.y_px);
  }
  void add(Velocity& velocity) {
    add(velocity.vx_px_per_s);
    add(velocity.vy_px_per_s);
  }
  void add(Clock& clock) {
    std::visit(*this, clock.base);
    if (!clock.jitter) return;
    add(clock.jitter->amount);
    add(clock.jitter->seed);
  }

  void operator()(FixedRate& rate) { add(rate.rate_hz); }
  void operator()(FixedStep& step) { add(step.dt_s); }
  void operator()(RecordedSteps& trace) {
    for (double& dt_s : trace.dt_s) add(dt_s);
  }
  void operator()(Fling& fling) { add(fling.velocity); }
  void operator()(Place& place) { add(place.position); }
  void operator()(Stop&) {}
  void operator()(Resize& resize) {
    if (resize.window) add(*resize.window);
    if (resize.sprite) add(*resize.sprite);
  }
  void operator()(Hitch& hitch) { add(hitch.dt_s); }
  void operator()(Grab&) {}
  void operator()(Release& release) { add(release.velocity); }

  [[nodiscard]] std::vector<Number> take() { return std::move(numbers_); }

 private:
  std::vector<Number> numbers_;
};

// The significant digits of a decimal text: those of its mantissa, without zeros at either end.
std::int64_t significant_digits(std::string_view text) {
  std::int64_t digits = 0;
  std::int64_t zeros = 0;  // Since the last other digit.
  for (const char letter : text.substr(0, text.find('e'))) {
    if (letter < '0' || letter > '9') continue;
    if (letter == '0') {
      zeros += digits > 0 ? 1 : 0;
    } else {
      digits += zeros + 1;
      zeros = 0;
    }
  }
  return digits;
}

template <class Value>
std::int64_t digits_in(const Value& value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value);
  return significant_digits({text, static_cast<std::size_t>(end.ptr - text)});
}

void round_value(double& value, int digits) {
  char text[40];
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::scientific, digits - 1);
  std::from_chars(text, end.ptr, value);
}

template <class Whole>
void round_value(Whole& value, int digits) {
  Whole unit = 1;
  for (Whole rest = value; rest != 0; rest /= 10)
    if (--digits < 0) unit *= 10;
  value = value / unit * unit;
}

}  // namespace

std::vector<Number> numbers_of(Scenario& scenario) {
  Collector collector;
  collector.add(scenario.window);
  collector.add(scenario.sprite);
  collector.add(scenario.start);
  collector.add(scenario.start_velocity);
  collector.add(scenario.clock);
  for (Event& event : scenario.events) std::visit(collector, event.action);
  return collector.take();
}

std::int64_t digits_of(const Scenario& scenario) {
  Scenario copy = scenario;
  std::int64_t digits = 0;
  for (const Number& number : numbers_of(copy))
    digits += std::visit([](const auto* value) { return digits_in(*value); }, number);
  return digits;
}

void round_to(const Number& number, int digits) {
  std::visit(
      [digits](auto* value) {
        if (digits == 0)
          *value = 0;
        else
          round_value(*value, digits);
      },
      number);
}

}  // namespace hyrax
