#include "sim/trajectory/state_hash.h"

#include <algorithm>
#include <utility>
#include <vector>

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace hyrax {
namespace {

Digest canonical(XXH128_hash_t hash) {
  XXH128_canonical_t bytes;
  XXH128_canonicalFromHash(&bytes, hash);
  Digest digest;
  std::copy(std::begin(bytes.digest), std::end(bytes.digest), digest.begin());
  return digest;
}

}  // namespace

Digest digest(std::span<const std::byte> bytes) {
  return canonical(XXH3_128bits(bytes.data(), bytes.size()));
}

Digest digest(const RowBlock& block) {
  return digest(std::span(block.data(), block.size() * kPackedRowBytes));
}

std::string hex(const Digest& digest) {
  constexpr char kDigits[] = "0123456789abcdef";
  std::string text;
  for (const std::uint8_t byte : digest) {
    text += kDigits[byte >> 4];
    text += kDigits[byte & 15];
  }
  return text;
}

struct ByteHash::State {
  XXH3_state_t xxh;
};

ByteHash::ByteHash() : state_(std::make_unique<State>()) { XXH3_128bits_reset(&state_->xxh); }
ByteHash::~ByteHash() = default;
ByteHash::ByteHash(const ByteHash& other) : state_(std::make_unique<State>()) {
  XXH3_copyState(&state_->xxh, &other.state_->xxh);
}
ByteHash::ByteHash(ByteHash&&) noexcept = default;
ByteHash& ByteHash::operator=(ByteHash&&) noexcept = default;

void ByteHash::add(std::span<const std::byte> bytes) {
  XXH3_128bits_update(&state_->xxh, bytes.data(), bytes.size());
}

Digest ByteHash::value() const { return canonical(XXH3_128bits_digest(&state_->xxh)); }

void StateHash::add(const Row& row) {
  std::array<std::byte, kPackedRowBytes> packed;
  pack_row(packed.data(), row);
  add_packed(packed);
}

void StateHash::add_packed(std::span<const std::byte> rows) {
  assert(rows.size() % kPackedRowBytes == 0);
  while (!rows.empty()) {
    const std::size_t count = std::min(kBlockRows - row_count_, rows.size() / kPackedRowBytes);
    rows_.add(rows.first(count * kPackedRowBytes));
    rows = rows.subspan(count * kPackedRowBytes);
    row_count_ += count;
    if (row_count_ < kBlockRows) return;
    row_count_ = 0;
    add(std::exchange(rows_, ByteHash()).value());
  }
}

void StateHash::add(const Digest& block, std::int64_t count) {
  assert(row_count_ == 0);
  constexpr std::int64_t kBatch = 4096;
  std::vector<Digest> batch(static_cast<std::size_t>(std::min(count, kBatch)), block);
  for (; count > 0; count -= kBatch)
    blocks_.add(std::as_bytes(std::span(batch.data(), static_cast<std::size_t>(std::min(count, kBatch)))));
}

Digest StateHash::value() const {
  if (row_count_ == 0) return blocks_.value();
  ByteHash all = blocks_;
  const Digest last = rows_.value();
  all.add(std::as_bytes(std::span(last)));
  return all.value();
}

}  // namespace hyrax
