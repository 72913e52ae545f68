// The paths of a scenario's golden file, and golden files without a scenario.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace hyrax {

struct GoldenPlace {
  std::string h5_path;       ///< The trajectory file.
  std::string txt_path;      ///< Its summary, for review in a diff.
  bool is_reserved = false;  ///< In golden/core/, which holds the accepted core.
  std::string folder = {};   ///< The golden folder that both are in.
};

/// The scenario's path relative to the nearest folder named `scenarios`, in `given` or in the `golden` beside
/// that folder; without such a folder its file name in `given`. Nothing without either folder.
/// `..` is resolved as the system does after links.
/// @param given the golden folder; empty if none was given.
[[nodiscard]] std::optional<GoldenPlace> golden_place(const std::string& scenario_path,
                                                      const std::string& given);

/// The same, for what has to have one. ERRORS: Failure(bad_input) without a place.
[[nodiscard]] GoldenPlace required_golden_place(const std::string& scenario_path, const std::string& given);

/// The golden folder of a scenario: `given` if it is not empty, else the `golden` beside the nearest folder
/// named `scenarios` above the file; empty without such a folder.
[[nodiscard]] std::string golden_folder_of(const std::string& scenario_path, const std::string& given = "");

/// The nearest folder named `scenarios` above the file; empty without one.
[[nodiscard]] std::string scenarios_folder_of(const std::string& scenario_path);

/// Whether both files exist. One without the other is a missing golden file.
/// ERRORS: Failure(bad_input) "PATH: is a pipe or a device ..." if one of them is, since reading it might
/// never end; and if the place is reserved.
[[nodiscard]] bool has_golden_file(const GoldenPlace& place);

/// Why a scenario without golden file has none: "no golden file at golden/a.h5: ...". For a terminal.
[[nodiscard]] std::string missing_golden_sentence(const std::optional<GoldenPlace>& place);

/// Whether a scenario is judged by its `expect.state_hash` instead of a golden file. Not if one part of a
/// golden file exists: the other was removed after it was blessed.
[[nodiscard]] bool is_judged_by_hash(bool expects_hash, const std::optional<GoldenPlace>& place);

inline constexpr char kUnreferencedSentence[] =
    "no scenario for this golden file: the scenario was deleted, moved or renamed";

struct UnreferencedGolden {
  std::string path;           ///< Without its suffix; of a golden folder that cannot be read, the folder.
  std::string error;          ///< "FOLDER: cannot be read: REASON"; else empty.
  std::string scenario_path;  ///< Where its scenario would be.
};

/// The golden files without a scenario, each once, in name order: for every folder among `arguments` that is
/// named `scenarios` or below one, those in the corresponding golden folder, recursively. They are a
/// disagreement: an accepted result is not checked any more. golden/core/, the accepted core, is left out.
/// @param golden_folder empty if none was given.
[[nodiscard]] std::vector<UnreferencedGolden> find_unreferenced(const std::vector<std::string>& arguments,
                                                                const std::string& golden_folder);

}  // namespace hyrax
