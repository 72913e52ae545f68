// What changed in a core's header, in its own words.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/core_record.h"
#include "sim/result/table.h"
#include "sim/trace/expression_text.h"
#include "sim/trace/traced_step.h"

namespace hyrax {

/// A number that the header gives a name, as in `static constexpr double GRAVITY = 1200.0;`.
struct HeaderConstant {
  std::string name;
  double value = 0.0;
  bool operator==(const HeaderConstant&) const = default;
};

/// In order of the header.
[[nodiscard]] std::vector<HeaderConstant> header_constants(std::string_view header);

/// The numbers of its other statements.
[[nodiscard]] std::vector<double> header_literals(std::string_view header);

/// What both headers call a number. Those that only one of them has stay numbers, and those that the
/// program's header writes as numbers, too; so do 0 and 1, which are in every step.
[[nodiscard]] NumberNames shared_names(std::string_view accepted, std::string_view program);

/// The names of the members of `class physics`: those that x(), y(), vx() and vy() return, then the others in
/// their order. Nothing where they cannot be told, as of members of another type than a number's.
[[nodiscard]] std::vector<std::string> header_members(std::string_view header);

enum class HeaderChangeKind : std::uint8_t { constant, added, removed, altered };
inline constexpr std::array<std::string_view, 4> kHeaderChangeNames = {"constant", "added", "removed",
                                                                       "altered"};

struct HeaderChange {
  HeaderChangeKind kind = HeaderChangeKind::altered;
  std::string detail;       ///< As "GRAVITY 1200 -> 1250", "m_vx *= AIR_DRAG;".
  std::int64_t line = 0;    ///< From 1, in the current header; of what was removed, in the accepted one.
  HeaderConstant from, to;  ///< Of a constant.
  std::string file = {};    ///< In which `line` is; empty: not known.
  std::optional<std::int64_t> scenarios =
      {};  ///< How many differing scenarios it reproduces alone, if tried.
};

/// Statement by statement; comments, blanks and line ends are no change.
/// @param file as HeaderChange::file.
[[nodiscard]] std::vector<HeaderChange> header_changes(std::string_view accepted, std::string_view current,
                                                       const std::string& file = {});

/// "line 41   constant: GRAVITY 1200 -> 1250"; behind another file than `header` its path.
[[nodiscard]] std::string change_text(const HeaderChange& change, std::string_view header = {});

/// `changes`: kind, detail, file, line; from and to of a constant; scenarios.
[[nodiscard]] Table changes_table(const std::vector<HeaderChange>& changes);

/// "GRAVITY 1200 -> 1250", "the core changed at lines 41 and 48, and at line 3 of pull.h", or both. REQUIRES:
/// there are changes. @param header the file whose name is left out.
[[nodiscard]] std::string changes_sentence(const std::vector<HeaderChange>& changes,
                                           std::string_view header = {});

/// Of a core's step against another's.
struct StepProof {
  bool is_complete = false;  ///< Both steps are.
  bool is_equal = false;  ///< The same operations on every path: the same bits for every state, dt and size.
  std::string why = {};   ///< Not equal.
};

inline constexpr std::string_view kProvedEqualText =
    "changed in text only: proved equal to the accepted core, the same operations on every path\n";

/// @param base_name as "the accepted core".
[[nodiscard]] StepProof prove_equal(const std::string& base_name, const CoreRecord& base,
                                    const CoreRecord& core);

/// The step in which every constant of a value has the value that it is mapped to, all at a time: canonical.
/// The step itself where it has none. REQUIRES: canonical.
[[nodiscard]] TracedStep with_constants(const TracedStep& step, const std::map<double, double>& values);

}  // namespace hyrax
