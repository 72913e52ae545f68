// The one value through which a core that describes itself is used, and one body of it.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "sim/core/core_record.h"
#include "sim/described/description.h"

namespace hyrax {

/// The lists of values that can be set.
enum class SettableList : std::uint8_t { state, inputs, parameters };

/// A range is no longer as long as in the description.
struct RangeLengthChanged : std::runtime_error {
  RangeLengthChanged(const std::string& range, std::size_t length_before, std::size_t length_now)
      : std::runtime_error(range + ": has " + std::to_string(length_now) + " elements, not the " +
                           std::to_string(length_before) + " of its description") {}
};

/// Rows as they are made, one after another: in each list the values of a row behind those of the row before.
struct MadeRows {
  std::vector<double> dt_s = {};  ///< Of each that is to be made.
  std::vector<Word> words = {};   ///< As they are hashed: dt, then the state.
  std::vector<Word> outputs = {};
  std::vector<std::uint8_t> contacts = {};    ///< 0 or 1,
  std::vector<std::uint8_t> properties = {};  ///< and whether each holds, or is shown.
  std::size_t count = 0;                      ///< Complete rows.
  bool all_are_finite = true;                 ///< Nothing in their states is not finite.
};

/// One core, as it goes on. ERRORS of all functions: what the core's own code throws; those that pass over a
/// list of values: RangeLengthChanged.
class DescribedBody {
 public:
  DescribedBody() = default;
  DescribedBody(const DescribedBody&) = delete;
  DescribedBody& operator=(const DescribedBody&) = delete;
  virtual ~DescribedBody() = default;

  /// By the core's copy constructor.
  [[nodiscard]] virtual std::unique_ptr<DescribedBody> copy() const = 0;
  virtual void step(double dt_s) = 0;
  /// Steps once for each dt of the rows to be made; behind each step calls `after_step`, if there is one, and
  /// adds a row. What throws leaves the rows before, and a body of no use. REQUIRES, of both: room for the
  /// rows, and their dt.
  virtual void play(const std::function<void()>& after_step, MadeRows& rows) = 0;
  /// Adds a row without a step. @param has_contacts whether its contacts are read; else they are 0.
  virtual void add_row(bool has_contacts, MadeRows& rows) = 0;
  /// Puts all values of a list there, in declared order. REQUIRES: as many as the list has.
  virtual void read(SettableList list, std::span<Word> words) = 0;
  /// Sets the given values in declared order, others not. REQUIRES: as many as the list has; words of the
  /// values' types.
  virtual void set(SettableList list, std::span<const std::optional<Word>> words) = 0;
  /// REQUIRES: an action of the description; a word for each argument.
  virtual void act(std::size_t action, std::span<const Word> arguments) = 0;
  /// As the lists are now: a core's have the same names and types in every call.
  [[nodiscard]] virtual Description describe() const = 0;
  /// 0 or 1 for each contact. REQUIRES: as many as the description has.
  virtual void contacts(std::span<std::uint8_t> flags) const = 0;
};

struct DescribedCore {
  Description description = {};
  /// Its header, the project's files that it includes, and its step as recorded (described_step.h).
  CoreRecord record = {};
  /// A default constructed body.
  std::function<std::unique_ptr<DescribedBody>()> make = {};
};

/// Named by the program; only its `main` asks for it. Defined by the one source that includes the core's
/// header.
[[nodiscard]] DescribedCore built_described_core();

}  // namespace hyrax
