// Hashes by which a golden file is known without being taken apart.
#pragma once

#include <optional>
#include <string>

#include "sim/trajectory/stored_run.h"

namespace hyrax {

/// What a digest says of its golden file. Where the file's bytes have their hash and a fresh run has
/// the contents', the two agree in everything that a comparison would look at.
struct GoldenSeal {
  std::string contents;  ///< XXH3-128 over all that the file says of the run, as 32 hex digits.
  std::string file;      ///< XXH3-128 over the file's bytes.
  bool operator==(const GoldenSeal&) const = default;
};

/// The hash of a run's contents: scenario (but for name, description and expect), physics model,
/// state hash, times, contacts, inputs and keyframes.
[[nodiscard]] std::string contents_hash(const StoredRun& run);

/// ERRORS: Failure(cannot_access) where the file cannot be read.
[[nodiscard]] std::string file_hash(const std::string& path);

/// The digest's line for it, and the seal that a digest names: nothing where it names none.
[[nodiscard]] std::string seal_line(const GoldenSeal& seal);
[[nodiscard]] std::optional<GoldenSeal> seal_in(const std::string& digest_text);

}  // namespace hyrax
