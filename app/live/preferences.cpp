#include "app/live/preferences.h"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <type_traits>

#include <fmt/format.h>

#include "app/console/failure.h"
#include "app/console/quoted.h"
#include "app/files/config_folder.h"
#include "app/files/input_file.h"
#include "app/files/output_file.h"
#include "app/files/toml_text.h"
#include "app/ui/window.h"

namespace ghostforce {
namespace {

namespace fs = std::filesystem;

// $XDG_STATE_HOME/ghostforce, or ~/.local/state/ghostforce; as config_folder() otherwise.
fs::path state_folder() {
  const char* const given = std::getenv("XDG_STATE_HOME");
  if (given != nullptr && fs::path(given).is_absolute()) return fs::path(given) / "ghostforce";
  const char* const home = std::getenv("HOME");
  if (home != nullptr && fs::path(home).is_absolute()) return fs::path(home) / ".local/state/ghostforce";
  return {};
}

fs::path preferences_file() {
  const fs::path where = config_folder();
  return where.empty() ? where : where / "preferences.toml";
}

fs::path layout_file() {
  const fs::path where = state_folder();
  return where.empty() ? where : where / "layout.toml";
}

// A file that says something wrong; the message is for the person.
struct Damaged {
  std::string what;
};

// Missing keys keep their value: an older program wrote the file.
template <typename Value>
void take(const toml::table& table, std::string_view key, Value& value) {
  const toml::node* const node = table.get(key);
  if (node == nullptr) return;
  // Whoever writes a 2 where a 2.0 could stand means the same.
  const bool is_whole = std::is_same_v<Value, double> && node->is_integer();
  const auto found = is_whole ? node->value<Value>() : node->value_exact<Value>();
  if (!found) throw Damaged{fmt::format("the value of {} has the wrong type", key)};
  value = *found;
}

// A window cannot be made smaller than `least`, whatever is written.
int take_length(const toml::table& table, std::string_view key, int length, int least) {
  constexpr std::int64_t longest = 32768;  // of any screen [px]
  std::int64_t value = length;
  take(table, key, value);
  if (value < 1 || value > longest) throw Damaged{fmt::format("{} = {} is no size of a window", key, value)};
  return std::max(static_cast<int>(value), least);
}

void read(const toml::table& table, Preferences& preferences) {
  std::string theme(preferences.look.theme->name);
  take(table, "theme", theme);
  preferences.look.theme = find_theme(theme);
  if (preferences.look.theme == nullptr) throw Damaged{fmt::format("there is no theme '{}'", printable(theme))};
  take(table, "scale", preferences.look.scale);
  if (!(preferences.look.scale >= Look::least_scale && preferences.look.scale <= Look::greatest_scale)) {
    throw Damaged{fmt::format("scale = {} is not between {} and {}", preferences.look.scale, Look::least_scale,
                              Look::greatest_scale)};
  }
  take(table, "hints", preferences.offers_hints);
}

void read(const toml::table& table, WindowLayout& layout) {
  layout.width = take_length(table, "width", layout.width, least_window_width);
  layout.height = take_length(table, "height", layout.height, least_window_height);
  take(table, "maximized", layout.is_maximized);
  if (const toml::node* const node = table.get("folded")) {
    const toml::array* const titles = node->as_array();
    if (titles == nullptr) throw Damaged{"the value of folded is no list"};
    for (const toml::node& title : *titles) {
      const auto text = title.value_exact<std::string>();
      if (!text) throw Damaged{"folded lists something that is no text"};
      layout.folded_panels.insert(*text);
    }
  }
}

std::string text_of(const Preferences& preferences) {
  return fmt::format("# Written by ghostforce; what the View panel chooses.\ntheme = {}\nscale = {:.4f}\nhints = {}\n",
                     toml_string(preferences.look.theme->name), preferences.look.scale, preferences.offers_hints);
}

std::string text_of(const WindowLayout& layout) {
  std::string folded;
  for (const std::string& title : layout.folded_panels) {
    folded += folded.empty() ? "" : ", ";
    folded += toml_string(title);
  }
  return fmt::format(
      "# Written by ghostforce when its window closes.\nwidth = {}\nheight = {}\nmaximized = {}\n"
      "folded = [{}]\n",
      layout.width, layout.height, layout.is_maximized, folded);
}

// Where a damaged file goes: a name that nothing has yet.
fs::path name_aside(const fs::path& file) {
  std::error_code error;
  for (int number = 1;; ++number) {
    fs::path aside = file;
    aside += number == 1 ? ".damaged" : fmt::format(".damaged-{}", number);
    if (!fs::exists(aside, error)) return aside;
  }
}

template <typename Value>
std::optional<Value> recall_from(const fs::path& file, std::vector<std::string>& remarks) {
  std::error_code error;
  if (file.empty() || !fs::exists(file, error)) return std::nullopt;
  const std::string shown = printable(file.string(), longest_path);
  if (!fs::is_regular_file(file, error)) {
    remarks.push_back(fmt::format("{} is no file; the usual values are used", shown));
    return std::nullopt;
  }
  const FileContents contents = file_contents(file);
  if (contents.error != 0) {
    remarks.push_back(fmt::format("{} cannot be read ({}); the usual values are used, and the file stays as it is",
                                  shown, unreadable_words(contents.error)));
    return std::nullopt;
  }
  try {
    const ParsedToml parsed = parse_toml(contents.text);
    if (parsed.problem) throw Damaged{fmt::format("line {}: {}", parsed.problem->position.line, parsed.problem->what)};
    Value value;
    read(parsed.table, value);
    return value;
  } catch (const Damaged& damage) {
    const fs::path aside = name_aside(file);
    fs::rename(file, aside, error);
    remarks.push_back(error ? fmt::format("{} is damaged ({}); the usual values are used", shown, damage.what)
                            : fmt::format("{} was damaged ({}) and is now {}; the usual values are used", shown,
                                          damage.what, printable(aside.string(), longest_path)));
    return std::nullopt;
  }
}

// `what` is kept in the file, for messages.
void write(const fs::path& file, const std::string& text, std::string_view what) {
  if (file.empty()) return;
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  if (error) {
    throw Failure(ExitCode::file_trouble,
                  fmt::format("the folder {} cannot be made: {}; {} kept there",
                              printable(file.parent_path().string(), longest_path), error.message(), what));
  }
  // A link to nothing yet is followed; into a pipe nobody may ever look.
  if (const std::string_view kind = kind_instead_of_file(file); !kind.empty() && fs::exists(file, error)) {
    throw Failure(ExitCode::file_trouble, fmt::format("{} is {}, and {} kept in a file of this name; remove it",
                                                      printable(file.string(), longest_path), kind, what));
  }
  // What cannot be read may be worth much all the same.
  const FileContents old = file_contents(file);
  if (old.error != 0 && old.error != ENOENT) {
    throw Failure(
        ExitCode::file_trouble,
        fmt::format("{} cannot be read ({}) and stays as it is, and {} kept in a file of this name; repair or "
                    "remove it",
                    printable(file.string(), longest_path), std::generic_category().message(old.error), what));
  }
  OutputFile output(file.string());
  output.write(text);
  output.commit();
}

}  // namespace

Remembered recall() {
  Remembered remembered;
  remembered.preferences = recall_from<Preferences>(preferences_file(), remembered.remarks).value_or(Preferences{});
  remembered.layout = recall_from<WindowLayout>(layout_file(), remembered.remarks);
  return remembered;
}

void remember(const Preferences& preferences) {
  write(preferences_file(), text_of(preferences), "preferences are");
}

void remember(const WindowLayout& layout) {
  write(layout_file(), text_of(layout), "the window's layout is");
}

}  // namespace ghostforce
