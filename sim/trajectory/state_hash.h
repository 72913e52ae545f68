// One hash over every row of a run, made of block digests.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "sim/trajectory/row_block.h"

namespace hyrax {

/// XXH3-128 (seed 0) in canonical, big-endian form.
using Digest = std::array<std::uint8_t, 16>;

[[nodiscard]] Digest digest(std::span<const std::byte> bytes);

/// The digest of bytes that arrive in pieces; how they are cut does not matter.
class ByteHash {
 public:
  ByteHash();
  ~ByteHash();
  ByteHash(ByteHash&&) noexcept;
  ByteHash& operator=(ByteHash&&) noexcept;

  void add(std::span<const std::byte> bytes);
  /// The digest of the bytes so far.
  [[nodiscard]] Digest value() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

[[nodiscard]] Digest digest(const RowBlock& block);

/// 32 lower-case hex digits.
[[nodiscard]] std::string hex(const Digest& digest);

/// XXH3-128 over the digests of all blocks in order; the last block may be shorter than 4,096 rows.
class StateHash {
 public:
  void add(const Digest& block) { add(block, 1); }
  /// The same block digest `count` times over.
  void add(const Digest& block, std::int64_t count);
  /// The hash of the blocks so far.
  [[nodiscard]] Digest value() const { return bytes_.value(); }

 private:
  ByteHash bytes_;
};

}  // namespace hyrax
