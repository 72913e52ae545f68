// All paths through a core that describes itself, compiled with recording numbers. It includes little: every
// such core is compiled with it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "sim/trace/host/number.h"

namespace hyrax {
struct TracedStep;
}

namespace hyrax::trace {

/// What is passed over the lists of such a core: it sets every value to an argument of its name, or reads
/// what has become of it. Any function may end in stop().
class DescribedPass {
 public:
  DescribedPass() = default;
  DescribedPass(const DescribedPass&) = delete;
  DescribedPass& operator=(const DescribedPass&) = delete;
  virtual ~DescribedPass() = default;

  virtual void enter(std::string_view part) = 0;
  virtual void enter(std::size_t place) = 0;
  virtual void leave() = 0;
  [[noreturn]] virtual void refuse(std::string_view name, std::string_view why) = 0;

  [[nodiscard]] virtual bool is_setting() const = 0;
  /// What a value is to be set to: the argument of its name; or of one that is no recording number the number
  /// that it has on this path, of these.
  [[nodiscard]] virtual Index given(NumberKind kind) = 0;
  [[nodiscard]] virtual std::int64_t given(std::int64_t low, std::int64_t high) = 0;
  /// It has been set. @param native_bytes its size, if it is no recording number; else 0.
  virtual void end_set(std::size_t native_bytes) = 0;
  virtual void read(Index value) = 0;
  virtual void read(std::int64_t value, std::int64_t low, std::int64_t high) = 0;
  /// The values that were passed are the parameters.
  virtual void end_parameters() = 0;
  virtual void add_contact(std::string_view name, bool is_touched) = 0;

  /// In the list of actions: whether this one is wanted, whose arguments have these names.
  [[nodiscard]] virtual bool wants_action(std::string_view name,
                                          std::span<const std::string_view> arguments) = 0;
  [[nodiscard]] virtual Index argument(NumberKind kind, std::string_view name) = 0;
};

/// A core, its type forgotten. It is made, copied and destroyed as bytes.
struct DescribedCalls {
  std::size_t size_bytes = 0;
  std::size_t align_bytes = 1;
  bool is_trivially_copyable = false;
  bool reads_alone = false;  ///< The lists of contacts, outputs and properties are const.
  void (*construct)(void* body) = nullptr;
  void (*values)(void* body, DescribedPass& pass) = nullptr;  ///< Parameters, inputs, state.
  void (*contacts)(void* body, DescribedPass& pass) = nullptr;
  void (*actions)(void* body, DescribedPass& pass) = nullptr;
  void (*step)(void* body, const Real& dt_s) = nullptr;
};

/// The step as recorded, not canonical. A step that is not complete ends in stop().
[[nodiscard]] TracedStep trace_described(const DescribedCalls& core);

/// The host's main program: record_main (explorer.h).
int record_main(const DescribedCalls& core, int argument_count, char** arguments);

}  // namespace hyrax::trace
