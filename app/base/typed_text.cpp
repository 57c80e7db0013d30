#include "app/base/typed_text.h"

#include <cstddef>
#include <vector>

#include <fmt/format.h>

#include "app/base/quoted.h"

namespace ghostforce {
namespace {

// Longer words are no slips of the keyboard, and comparing them would take long.
constexpr std::size_t longest_word = 80;
// A beginning shorter than this could be that of anything.
constexpr std::size_t shortest_beginning = 3;

char lower(char c) noexcept {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

// Optimal string alignment distance: insertions, deletions, substitutions and swaps of neighbours, each 1.
std::size_t slips_between(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before_last(b.size() + 1);
  std::vector<std::size_t> last(b.size() + 1);
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before_last.swap(last);
    last.swap(row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool same = lower(a[i - 1]) == lower(b[j - 1]);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (same ? 0 : 1)});
      const bool swapped = i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1]);
      if (swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
  }
  return row[b.size()];
}

bool begins_with(std::string_view text, std::string_view beginning) noexcept {
  return std::ranges::equal(text.substr(0, beginning.size()), beginning, {}, lower, lower);
}

}  // namespace

std::optional<std::string_view> nearest_name(std::string_view word, std::span<const std::string_view> candidates) {
  if (word.empty() || word.size() > longest_word) return std::nullopt;
  std::optional<std::string_view> nearest;
  // A slip in every third letter is the most that is still the same word.
  std::size_t fewest = std::max<std::size_t>(1, word.size() / 3) + 1;
  for (const std::string_view candidate : candidates) {
    if (candidate.size() > longest_word) continue;
    const bool is_beginning = word.size() >= shortest_beginning && begins_with(candidate, word);
    const std::size_t slips =
        is_beginning ? std::min<std::size_t>(1, candidate.size() - word.size()) : slips_between(word, candidate);
    if (slips < fewest && slips < std::max(word.size(), candidate.size())) {
      fewest = slips;
      nearest = candidate;
    }
  }
  return nearest;
}

std::string not_one_of(std::string_view word, std::span<const std::string_view> words) {
  if (std::ranges::find(words, word) != words.end()) return {};
  return fmt::format("'{}' is not one of {}{}", quoted_text(word), listed(words), did_you_mean(word, words));
}

std::string did_you_mean(std::string_view word, std::span<const std::string_view> candidates) {
  const std::optional<std::string_view> nearest = nearest_name(word, candidates);
  return nearest ? "; did you mean '" + std::string(*nearest) + "'?" : "";
}

}  // namespace ghostforce
