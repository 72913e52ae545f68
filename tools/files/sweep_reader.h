// Reads and writes sweeps in the format `hyrax-sweep/1`.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "sim/scenario/sweep.h"
#include "tools/files/json.h"

namespace hyrax {

inline constexpr std::string_view kSweepFormat = "hyrax-sweep/1";

/// A sweep of any core, as its file has it.
struct SweepDocument {
  SweepPlan plan = {};
  Json base = {};  ///< Without `expect`, with a name.
  /// The sweep complete in itself: its base inside and without `expect`, defaults filled in. Two sweeps are
  /// the same if this text is.
  std::string text = {};
  std::string base_path = {};  ///< Empty if the base was inside the file.
};

/// What the reader of sweeps asks of a core's scenarios.
class SweptScenarios {
 public:
  SweptScenarios() = default;
  SweptScenarios(const SweptScenarios&) = delete;
  SweptScenarios& operator=(const SweptScenarios&) = delete;
  virtual ~SweptScenarios() = default;

  /// Kind and names of the key at a pointer. One that no scenario has is of any kind.
  [[nodiscard]] virtual VariedKey key_at(const std::string& pointer) const = 0;
  /// Reads a scenario. The first one is member 0. ERRORS: as to_scenario's.
  virtual void read(const Json& document, const std::string& source) = 0;
  /// Whether the key names a number of member 0. REQUIRES, as of the others: that was read.
  [[nodiscard]] virtual bool has_number(const VariedKey& key) = 0;
  /// Whether the number is within the key's own limits.
  [[nodiscard]] virtual bool allows(const VariedKey& key, const SweepNumber& number) = 0;
  /// ERRORS: as read_member's, for the first member that is invalid though each of its numbers is allowed.
  virtual void check_members(const SweepDocument& sweep, const std::string& source) = 0;
};

/// Sets the varied numbers of a scenario's document to a member's.
/// ERRORS: Failure(bad_input) "SOURCE: POINTER: ...".
void set_member(const SweepPlan& plan, std::int64_t member, const std::string& source, Json& document);
/// Reads the scenario of a member. ERRORS: Failure(bad_input) "SOURCE: member I: POINTER: ...".
void read_member(SweptScenarios& scenarios, const SweepDocument& sweep, std::int64_t member,
                 const std::string& source);

/// Which members are checked: all of them, or, of a text that was checked before, the first one.
enum class SweepCheck : std::uint8_t { all_members, first_member };

/// A sweep from its text, and its base. @param source names it in messages.
/// ERRORS: Failure(cannot_access) if the base cannot be read; Failure(bad_input) with a line for every error,
/// "PATH: POINTER: RULE (found VALUE)", or for the first invalid member, "PATH: member I: POINTER: ...".
[[nodiscard]] SweepDocument read_sweep(SweptScenarios& scenarios, std::string_view text,
                                       const std::string& source, SweepCheck check = SweepCheck::all_members);

/// A sweep of the paper's interface.
struct SweepFile {
  Sweep sweep;
  std::string text;       ///< As the document's.
  std::string base_path;  ///< As the document's.
};

/// Reads a sweep file, and its base. ERRORS: as read_sweep's and read_text_file's.
[[nodiscard]] SweepFile load_sweep(const std::string& path);

/// A sweep from its text. ERRORS: as read_sweep's.
[[nodiscard]] SweepFile parse_sweep(std::string_view text, const std::string& source,
                                    SweepCheck check = SweepCheck::all_members);

/// A member as a scenario of its own, named after the base and the member.
[[nodiscard]] Scenario member_scenario(const Sweep& sweep, std::int64_t member);

}  // namespace hyrax
