#include "tools/files/unknown_word.h"

#include <algorithm>

#include "tools/files/printable.h"

namespace hyrax {
namespace {

constexpr std::size_t kWordsListedMax = 40;
constexpr std::size_t kSuggestedMax = 40;  // Longer words get no suggestion: the time is quadratic.

char lower(char letter) {
  return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
}

// Letters to insert, remove, replace or exchange with their neighbour, whatever their case.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> distance(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      std::size_t& least = distance[i][j];
      least = std::max(i, j);
      if (i == 0 || j == 0) continue;
      const auto is_same = [&](std::size_t m, std::size_t n) { return lower(a[m - 1]) == lower(b[n - 1]); };
      least = std::min(
          {distance[i - 1][j] + 1, distance[i][j - 1] + 1, distance[i - 1][j - 1] + (is_same(i, j) ? 0 : 1)});
      if (i > 1 && j > 1 && is_same(i, j - 1) && is_same(i - 1, j))
        least = std::min(least, distance[i - 2][j - 2] + 1);
    }
  }
  return distance[a.size()][b.size()];
}

std::string_view suggestion(std::string_view found, const std::vector<std::string_view>& allowed) {
  if (found.empty() || found.size() > kSuggestedMax || allowed.size() < 2) return {};
  std::string_view nearest;
  std::size_t least = (found.size() + 2) / 3 + 1;
  for (const std::string_view word : allowed) {
    const std::size_t errors =
        word.substr(0, found.size()) == found ? std::size_t{1} : edit_distance(found, word);
    if (errors < std::min(least, word.size())) {
      least = errors;
      nearest = word;
    }
  }
  return nearest;
}

}  // namespace

std::string listed(std::span<const std::string_view> words) {
  if (words.empty()) return "none";
  std::string list(words.front());
  const std::size_t count = std::min(words.size(), kWordsListedMax);
  for (const std::string_view word : words.subspan(1, count - 1)) list.append(", ").append(word);
  return words.size() > count ? list + " and " + std::to_string(words.size() - count) + " more" : list;
}

std::string unknown_word(std::string_view kind, std::string_view found,
                         const std::vector<std::string_view>& allowed) {
  std::string sentence =
      "unknown " + std::string(kind) + " (found " + shortened(found) + "); allowed: " + listed(allowed);
  if (const std::string_view nearest = suggestion(found, allowed); !nearest.empty())
    sentence.append(" (did you mean ").append(nearest).append("?)");
  return sentence;
}

}  // namespace hyrax
