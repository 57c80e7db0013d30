// A text that a person names: one of those that are part of the program by its name, any other by its path. Scenes and
// lessons are found in this way. Not for the servo thread.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "embedded_text.h"

namespace ghostforce {

// Of texts that are part of the program, in their order: the files' names without .toml.
std::vector<std::string_view> names_of_texts(std::span<const EmbeddedText> shipped);

// Null: none has that name.
const EmbeddedText* find_text(std::span<const EmbeddedText> shipped, std::string_view name) noexcept;

// Of a name that is neither that of a file nor of a shipped text: "no scene named 'wal45'", "there is no file 'my.toml'".
std::string words_of_missing_text(std::string_view kind, const std::string& name_or_path);

// A word without '/' that names one of the shipped texts is that one. `kind` is what such a text is called in messages:
// "scene". Throws ReadError: wrong where there is none, with what may have been meant; unreadable.
std::string named_text(const std::string& name_or_path, std::string_view kind, std::span<const EmbeddedText> shipped);

}  // namespace ghostforce
