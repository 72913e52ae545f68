// Where a scenario's golden file stands.
#pragma once

#include <optional>
#include <string>

namespace hyrax {

struct GoldenPlace {
  std::string h5_path;   ///< The trajectory file.
  std::string txt_path;  ///< Its digest, made for review in a diff.
};

/// By the scenario's path, `..` resolved as the system does behind links, below the nearest folder named
/// `scenarios`, in `golden_folder` or in the `golden` beside that folder; else by its file name in
/// `golden_folder`. Nothing where neither says a place.
/// @param golden_folder empty where none was given.
[[nodiscard]] std::optional<GoldenPlace> golden_place(const std::string& scenario_path,
                                                      const std::string& golden_folder);

/// The `golden` beside the nearest folder named `scenarios` that the file is below; empty where there is
/// none.
[[nodiscard]] std::string golden_folder_of(const std::string& scenario_path);

/// Whether a golden file is there: both of its parts. One without the other is a missing golden file.
/// ERRORS: Failure(bad_input) "PATH: is a pipe or a device ..." where it or its digest is one, for reading
/// that might never come to an end.
[[nodiscard]] bool has_golden_file(const GoldenPlace& place);

}  // namespace hyrax
