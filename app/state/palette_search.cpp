#include "app/state/palette_search.h"

#include <algorithm>
#include <optional>
#include <tuple>

namespace ghostforce {
namespace {

constexpr bool is_of_word(char letter) noexcept {
  const auto byte = static_cast<unsigned char>(letter);
  return byte >= 0x80 || (letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9');
}

bool begins_word(std::string_view text, std::size_t at) noexcept {
  return at == 0 || !is_of_word(text[at - 1]);
}

bool has_word_with(std::string_view text, std::string_view beginning) noexcept {
  for (std::size_t at = text.find(beginning); at != std::string_view::npos; at = text.find(beginning, at + 1)) {
    if (begins_word(text, at)) return true;
  }
  return false;
}

std::vector<std::string_view> words_in_line(std::string_view line) {
  std::vector<std::string_view> words;
  while (!line.empty()) {
    const std::size_t end = std::min(line.find(' '), line.size());
    if (end > 0) words.push_back(line.substr(0, end));
    line.remove_prefix(std::min(end + 1, line.size()));
  }
  return words;
}

// How far from what was meant: its first word, a word of it, one of its further words, a part of one. Empty: nowhere.
std::optional<int> distance_of(std::string_view words, std::string_view also, std::string_view sought) {
  if (words.starts_with(sought)) return 0;
  if (has_word_with(words, sought)) return 1;
  if (has_word_with(also, sought)) return 2;
  if (words.find(sought) != std::string_view::npos || also.find(sought) != std::string_view::npos) return 3;
  return std::nullopt;
}

}  // namespace

std::string folded(std::string_view text) {
  // U+00C0 to U+00FF, which UTF-8 writes as 0xC3 and one byte more.
  constexpr std::string_view plain = "aaaaaaaceeeeiiiidnooooo*ouuuuytsaaaaaaaceeeeiiiidnooooo/ouuuuyty";
  static_assert(plain.size() == 64);
  std::string small;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char letter = text[i];
    if (letter == '\xC3' && i + 1 < text.size()) {
      small += plain[static_cast<unsigned char>(text[++i]) & 0x3FU];
    } else {
      small += letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
    }
  }
  return small;
}

std::vector<std::size_t> find_in_palette(std::span<const PaletteEntry> entries, std::string_view sought) {
  const std::string line = folded(sought);
  const std::vector<std::string_view> wanted = words_in_line(line);
  std::vector<std::tuple<int, bool, std::size_t>> found;  // in the order in which they are to be
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const std::string words = folded(entries[i].words);
    const std::string also = folded(entries[i].also);
    int sum = 0;
    const bool has_all = std::ranges::all_of(wanted, [&](std::string_view each) {
      const std::optional<int> distance = distance_of(words, also, each);
      sum += distance.value_or(0);
      return distance.has_value();
    });
    if (has_all) found.emplace_back(sum, !entries[i].refusal.empty(), i);
  }
  std::ranges::sort(found);
  std::vector<std::size_t> numbers;
  for (const auto& [distance, is_refused, number] : found) numbers.push_back(number);
  return numbers;
}

}  // namespace ghostforce
