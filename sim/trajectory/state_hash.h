// Rows as they are hashed: packed to 41 bytes, in blocks of 4,096, whose digests make one hash over a run.
#pragma once

#include <array>
#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <string>

#include "sim/trajectory/reused.h"
#include "sim/trajectory/row.h"

namespace hyrax {

inline constexpr std::size_t kBlockRows = 4096;
inline constexpr std::size_t kPackedRowBytes = 41;

/// A word with its bytes in little-endian order, from this machine's, and back.
[[nodiscard]] constexpr std::uint64_t little_endian(std::uint64_t bits) {
  if constexpr (std::endian::native == std::endian::little) return bits;
  std::uint64_t swapped = 0;
  for (int byte = 0; byte < 8; ++byte, bits >>= 8) swapped = swapped << 8 | (bits & 0xff);
  return swapped;
}

/// A double to and from little-endian binary64.
[[nodiscard]] inline std::uint64_t little_endian_bits(double value) {
  return little_endian(std::bit_cast<std::uint64_t>(value));
}
[[nodiscard]] inline double from_little_endian(const std::byte* bytes) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, bytes, sizeof bits);
  return std::bit_cast<double>(little_endian(bits));
}

inline void store_little_endian(std::byte* at, double value) {
  const std::uint64_t bits = little_endian_bits(value);
  std::memcpy(at, &bits, sizeof bits);
}

/// Writes one packed row: little-endian binary64 dt, x, y, vx, vy and the contact byte.
inline void pack_row(std::byte* at, double dt_s, double x_px, double y_px, double vx_px_per_s,
                     double vy_px_per_s, std::uint8_t contact) {
  store_little_endian(at, dt_s);
  store_little_endian(at + 8, x_px);
  store_little_endian(at + 16, y_px);
  store_little_endian(at + 24, vx_px_per_s);
  store_little_endian(at + 32, vy_px_per_s);
  at[40] = std::byte{contact};
}

/// Sets vx of a packed row.
inline void set_packed_vx(std::byte* at, double vx_px_per_s) { store_little_endian(at + 24, vx_px_per_s); }

inline void pack_row(std::byte* at, const Row& row) {
  pack_row(at, row.dt_s, row.x_px, row.y_px, row.vx_px_per_s, row.vy_px_per_s, row.contact);
}

/// Consecutive packed rows, up to a block of them.
class RowBlock {
 public:
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::size_t room() const { return kBlockRows - size_; }
  [[nodiscard]] const std::byte* data() const { return bytes_->at; }

  /// Makes room for `count` further rows and returns where they begin. REQUIRES: count <= room().
  [[nodiscard]] std::byte* extend(std::size_t count) {
    assert(count <= room());
    std::byte* const begin = bytes_->at + size_ * kPackedRowBytes;
    size_ += count;
    return begin;
  }
  /// Keeps the first `size` rows. REQUIRES: size <= size().
  void shrink(std::size_t size) {
    assert(size <= size_);
    size_ = size;
  }

  /// Appends rows `first` .. `first + count - 1` of another block. REQUIRES: they fit.
  void append(const RowBlock& other, std::size_t first, std::size_t count) {
    assert(first + count <= other.size_);
    std::memcpy(extend(count), other.bytes_->at + first * kPackedRowBytes, count * kPackedRowBytes);
  }

  void append(const Row& row) { pack_row(extend(1), row); }

  /// REQUIRES: index < size().
  void set_contact(std::size_t index, std::uint8_t contact) {
    assert(index < size_);
    bytes_->at[index * kPackedRowBytes + kPackedRowBytes - 1] = std::byte{contact};
  }
  /// Row `index` of the block, without its step and time. REQUIRES: index < size().
  [[nodiscard]] Row row(std::size_t index) const {
    assert(index < size_);
    const std::byte* bytes = bytes_->at + index * kPackedRowBytes;
    return {.dt_s = from_little_endian(bytes),
            .x_px = from_little_endian(bytes + 8),
            .y_px = from_little_endian(bytes + 16),
            .vx_px_per_s = from_little_endian(bytes + 24),
            .vy_px_per_s = from_little_endian(bytes + 32),
            .contact = std::to_integer<std::uint8_t>(bytes[40])};
  }

 private:
  struct Bytes {
    Bytes() {}  // NOLINT(modernize-use-equals-default): they are not set to 0.
    std::byte at[kBlockRows * kPackedRowBytes];
  };
  Reused<Bytes> bytes_;
  std::size_t size_ = 0;
};

/// XXH3-128 (seed 0) in canonical, big-endian form.
using Digest = std::array<std::uint8_t, 16>;

[[nodiscard]] Digest digest(std::span<const std::byte> bytes);
[[nodiscard]] Digest digest(const RowBlock& block);

/// 32 lower-case hex digits.
[[nodiscard]] std::string hex(const Digest& digest);

/// The digest of bytes that arrive in pieces; how they are cut does not matter.
class ByteHash {
 public:
  ByteHash();
  ~ByteHash();
  ByteHash(const ByteHash& other);
  ByteHash(ByteHash&&) noexcept;
  ByteHash& operator=(ByteHash&&) noexcept;

  void add(std::span<const std::byte> bytes);
  /// The digest of the bytes so far.
  [[nodiscard]] Digest value() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// XXH3-128 over the digests of all blocks of a run in order; the last block may be shorter than 4,096 rows.
class StateHash {
 public:
  /// Rows in order, packed or not.
  void add(const Row& row);
  void add_packed(std::span<const std::byte> rows);
  /// Complete blocks: the digest of one, `count` times over. REQUIRES: the rows added so far fill their
  /// blocks, or this is the last one.
  void add(const Digest& block, std::int64_t count = 1);
  /// The hash of what was added so far.
  [[nodiscard]] Digest value() const;

 private:
  ByteHash blocks_;
  ByteHash rows_;  // Of the block that is not full.
  std::size_t row_count_ = 0;
};

}  // namespace hyrax
