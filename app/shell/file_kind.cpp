#include "app/shell/file_kind.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "app/base/typed_text.h"
#include "app/files/input_file.h"
#include "app/files/run.h"

namespace ghostforce {
namespace {

struct FileKindEntry {
  FileKind id;
  std::string_view words;
  bool (*begins_like_one)(std::string_view beginning);
  std::array<std::string_view, 3> endings;  // of names; empty: no more of them
};

bool has_line(std::string_view text, std::string_view beginning) {
  for (std::size_t at = text.find(beginning); at != std::string_view::npos; at = text.find(beginning, at + 1)) {
    if (at == 0 || text[at - 1] == '\n') return true;
  }
  return false;
}

bool begins_like_picture(std::string_view text) {
  const bool is_svg = trimmed(text).starts_with('<') && text.find("<svg") != std::string_view::npos;
  return text.starts_with("\x89PNG\r\n") || text.starts_with("%PDF-") || is_svg;
}

bool begins_like_run(std::string_view text) {
  return text.starts_with("# ghostforce ") || has_line(text, run_columns);
}

// Every step of a lesson has such a line, and no scene has.
bool begins_like_lesson(std::string_view text) {
  return has_line(text, "[[step]]");
}

bool begins_like_scene(std::string_view text) {
  return has_line(text, "format") || has_line(text, "[wall]");
}

// The first that fits.
constexpr std::array kinds{
    FileKindEntry{FileKind::picture,
                  "a picture that ghostforce has saved (.png, .svg, .pdf)",
                  begins_like_picture,
                  {".png", ".svg", ".pdf"}},
    FileKindEntry{FileKind::run, "a recording (.csv)", begins_like_run, {".csv"}},
    FileKindEntry{FileKind::lesson, "a lesson (.toml)", begins_like_lesson, {}},
    FileKindEntry{FileKind::scene, "a scene (.toml)", begins_like_scene, {".toml"}},
};

bool ends_like(std::string_view path, std::string_view ending) {
  if (ending.empty() || path.size() < ending.size()) return false;
  return std::ranges::equal(path.substr(path.size() - ending.size()), ending, {},
                            [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
}

// Empty: there is none, or it cannot be read.
std::optional<std::string> beginning_of(const std::string& path) {
  constexpr std::size_t enough = 1 << 16;
  std::string text;
  const int error = read_pieces(path, [&text](std::string_view piece) {
    text += piece;
    return text.size() < enough;
  });
  return error == 0 ? std::optional(std::move(text)) : std::nullopt;
}

}  // namespace

std::optional<FileKind> kind_of_file(const std::string& path) {
  if (!kind_instead_of_file(path).empty()) return std::nullopt;
  const std::optional<std::string> beginning = beginning_of(path);
  if (!beginning) return FileKind::scene;
  for (const FileKindEntry& kind : kinds) {
    if (kind.begins_like_one(*beginning)) return kind.id;
  }
  for (const FileKindEntry& kind : kinds) {
    if (std::ranges::any_of(kind.endings, [&](std::string_view ending) { return ends_like(path, ending); })) {
      return kind.id;
    }
  }
  return std::nullopt;
}

std::string file_kinds_words() {
  std::string words;
  for (const FileKindEntry& kind : kinds) words.append(words.empty() ? "" : "; ").append(kind.words);
  return words;
}

}  // namespace ghostforce
