#include "app/files/named_text.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "app/base/quoted.h"
#include "app/base/typed_text.h"
#include "app/files/input_file.h"

namespace ghostforce {
namespace {

constexpr std::string_view extension = ".toml";

std::string_view name_of(const EmbeddedText& text) noexcept {
  return text.name.substr(0, text.name.size() - extension.size());
}

// What the person may have meant by a name that is nothing: a file nearby, or a shipped text.
std::optional<std::string> meant_by(const std::filesystem::path& path, std::span<const std::string_view> shipped) {
  const std::string stem = path.extension() == extension ? path.stem().string() : path.filename().string();
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  const auto name_of = [](const std::filesystem::path& file) {
    return file.extension() == extension ? file.stem().string() : "";
  };
  if (const auto near = nearest_name_in(folder, stem, name_of)) {
    const std::string found = *near + std::string(extension);
    return path.has_parent_path() ? (folder / found).string() : found;
  }
  if (const auto near = nearest_name(stem, shipped)) return std::string(*near);
  return std::nullopt;
}

}  // namespace

std::vector<std::string_view> names_of_texts(std::span<const EmbeddedText> shipped) {
  std::vector<std::string_view> names;
  for (const EmbeddedText& text : shipped) names.push_back(name_of(text));
  return names;
}

const EmbeddedText* find_text(std::span<const EmbeddedText> shipped, std::string_view name) noexcept {
  const auto found = std::ranges::find(shipped, name, name_of);
  return found == shipped.end() ? nullptr : &*found;
}

std::string words_of_missing_text(std::string_view kind, const std::string& name_or_path) {
  const std::string shown = quoted_text(name_or_path, longest_path);
  const bool is_path = name_or_path.find('/') != std::string::npos || name_or_path.ends_with(extension);
  return is_path ? fmt::format("there is no file '{}'", shown) : fmt::format("no {} named '{}'", kind, shown);
}

std::string named_text(const std::string& name_or_path, std::string_view kind, std::span<const EmbeddedText> shipped) {
  if (const EmbeddedText* const text = find_text(shipped, name_or_path)) return std::string(text->contents);
  FileContents file = file_contents(name_or_path);
  const std::string shown = quoted_text(name_or_path, longest_path);
  const auto fail = [&](std::string what, std::string remedy) {
    return ReadError(ReadError::Kind::wrong, {{.file = shown, .what = std::move(what), .remedy = std::move(remedy)}});
  };
  switch (name_or_path.empty() ? ENOENT : file.error) {
    case 0:
      return std::move(file.text);
    case ENOENT:
    case ENOTDIR:
    case ENAMETOOLONG: {
      std::vector<std::string_view> names = names_of_texts(shipped);
      std::sort(names.begin(), names.end());
      const std::optional<std::string> meant = meant_by(name_or_path, names);
      throw ReadError(ReadError::Kind::wrong,
                      {{.what = words_of_missing_text(kind, name_or_path),
                        .remedy = meant ? fmt::format("did you mean '{}'?", quoted_text(*meant))
                                        : fmt::format("give the path of a file, or one of {}", listed(names)),
                        .suggestion = meant.value_or("")}});
    }
    case EISDIR:
      throw fail("is a folder", fmt::format("name a {} file in it", kind));
    case EFBIG:
      throw fail(fmt::format("is larger than {} MiB, too large for a {}", largest_text_file >> 20, kind),
                 fmt::format("name a {} file", kind));
    default:
      throw unreadable(shown, file.error, ": ");
  }
}

}  // namespace ghostforce
