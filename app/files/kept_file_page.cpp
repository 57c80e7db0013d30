#include <emscripten.h>

#include <cstdlib>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "app/base/failure.h"
#include "app/files/kept_file.h"
#include "app/files/kept_text.h"

EM_JS_DEPS(kept_file, "$UTF8ToString,$stringToNewUTF8")

// Where storage is forbidden even looking for it throws.
// clang-format off
EM_JS(char*, read_stored_text, (const char* key), {
  try {
    const text = localStorage.getItem(UTF8ToString(key));
    return text === null ? 0 : stringToNewUTF8(text);
  } catch (error) {
    return 0;
  }
})

EM_JS(bool, store_text, (const char* key, const char* text), {
  try {
    localStorage.setItem(UTF8ToString(key), UTF8ToString(text));
    return true;
  } catch (error) {
    return false;
  }
})

EM_JS(void, remove_stored_text, (const char* key), {
  try {
    localStorage.removeItem(UTF8ToString(key));
  } catch (error) {
  }
})
// clang-format on

namespace ghostforce {
namespace {

std::optional<std::string> stored_text(const std::string& key) {
  const std::unique_ptr<char, void (*)(void*)> text(read_stored_text(key.c_str()), std::free);
  return text ? std::optional<std::string>(text.get()) : std::nullopt;
}

std::string kept_name(const KeptFile& file) {
  return file.path.filename().string();
}

std::string key_of(std::string_view name) {
  return fmt::format("ghostforce:{}", name);
}

// Where a damaged text goes: a name that nothing has yet.
std::string name_aside(const std::string& name) {
  for (int number = 1;; ++number) {
    std::string aside = number == 1 ? name + ".damaged" : fmt::format("{}.damaged-{}", name, number);
    if (!stored_text(key_of(aside))) return aside;
  }
}

}  // namespace

bool load(const KeptFile& file, const std::function<void(TomlReader&)>& read, std::vector<std::string>& remarks) {
  if (file.path.empty()) return false;
  const std::string name = kept_name(file);
  const std::optional<std::string> text = stored_text(key_of(name));
  if (!text) return false;
  if (is_of_newer_format(*text)) {
    remarks.push_back(fmt::format("{} in this browser's storage was written by a newer version of ghostforce, so {}",
                                  name, file.without));
    return false;
  }
  TomlReader reader(name);
  if (reader.parse(*text)) read(reader);
  const std::vector<ReadProblem> problems = reader.problems();
  if (problems.empty()) return true;

  const std::string damage = damage_words(problems);
  const std::string aside = name_aside(name);
  if (store_text(key_of(aside).c_str(), text->c_str())) {
    remove_stored_text(key_of(name).c_str());
    remarks.push_back(fmt::format("{} in this browser's storage was damaged ({}) and is now {}; {}", name, damage,
                                  aside, file.without));
  } else {
    remarks.push_back(fmt::format("{} in this browser's storage is damaged ({}), so {}", name, damage, file.without));
  }
  return false;
}

void save(const KeptFile& file, std::string_view text, std::span<const std::string_view> keys) {
  if (file.path.empty()) return;
  const std::string key = key_of(kept_name(file));
  const std::string old = stored_text(key).value_or("");
  if (is_of_newer_format(old)) return;  // the page has said so when it read it
  std::string whole = kept_beginning(file.comment);
  whole += text;
  if (!keys.empty()) whole += without_named_keys(old, keys);
  // Every change would say the same again.
  static bool is_told = false;
  if (store_text(key.c_str(), whole.c_str())) {
    is_told = false;
  } else if (!is_told) {
    is_told = true;
    throw Failure(ExitCode::file_trouble,
                  fmt::format("Your browser does not let this page keep anything, so {} not kept. Allow it to store "
                              "data, and make room if its storage is full.",
                              file.contents));
  }
}

void forget(const KeptFile& file) {
  if (!file.path.empty()) remove_stored_text(key_of(kept_name(file)).c_str());
}

}  // namespace ghostforce
