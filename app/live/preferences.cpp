#include "app/live/preferences.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>
#include <span>
#include <system_error>

#include <fmt/format.h>

#include "app/console/failure.h"
#include "app/console/quoted.h"
#include "app/files/input_file.h"
#include "app/files/output_file.h"
#include "app/files/toml_document.h"
#include "app/files/xdg_folders.h"
#include "app/ui/window.h"

namespace ghostforce {
namespace {

namespace fs = std::filesystem;

fs::path preferences_file() {
  const fs::path where = config_folder();
  return where.empty() ? where : where / "preferences.toml";
}

fs::path layout_file() {
  const fs::path where = state_folder();
  return where.empty() ? where : where / "layout.toml";
}

void read(TomlReader& reader, Preferences& preferences) {
  reader.read_values(std::array{
      TomlKey{"", "theme",
              catalog_entry(theme_catalog(), [&](const Theme& theme) { preferences.appearance.theme = &theme; })},
      TomlKey{"", "scale",
              number_into(preferences.appearance.scale, {Appearance::least_scale, Appearance::greatest_scale})},
      TomlKey{"", "arrows",
              number_into(preferences.appearance.arrow_scale,
                          {Appearance::least_arrow_scale, Appearance::greatest_arrow_scale})},
      TomlKey{"", "hints", yes_or_no_into(preferences.offers_hints)},
      TomlKey{"", "view",
              catalog_entry(std::span<const FaceEntry>(face_catalog),
                            [&](const FaceEntry& entry) { preferences.face = entry.id; })},
  });
}

void read(TomlReader& reader, WindowLayout& layout) {
  const NumberLimits length{.least = 1.0, .greatest = 32768.0, .unit = "pixels", .whole = true};  // of any screen
  const auto read_folded = [&](const TomlValue& titles) {
    const std::size_t count = titles.count("give a list of panels").value_or(0);
    for (std::size_t i = 0; i < count; ++i) {
      if (const auto title = titles[i].text()) layout.folded_panels.insert(*title);
    }
  };
  reader.read_values(std::array{
      TomlKey{"", "width", number_into(layout.width, length)},
      TomlKey{"", "height", number_into(layout.height, length)},
      TomlKey{"", "maximized", yes_or_no_into(layout.is_maximized)},
      TomlKey{"", "folded", read_folded},
  });
  // A window cannot be made smaller, whatever is written.
  layout.width = std::max(layout.width, least_window_width);
  layout.height = std::max(layout.height, least_window_height);
}

std::string text_of(const Preferences& preferences) {
  return fmt::format(
      "# Written by ghostforce: what the View panel and F4 choose.\ntheme = {}\nscale = {:.4f}\narrows = {:.4f}\n"
      "hints = {}\nview = {}\n",
      toml_string(preferences.appearance.theme->name), preferences.appearance.scale, preferences.appearance.arrow_scale,
      preferences.offers_hints, toml_string(face_name(preferences.face)));
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
std::optional<Value> load_from(const fs::path& file, std::vector<std::string>& remarks) {
  std::error_code error;
  if (file.empty() || !fs::exists(file, error)) return std::nullopt;
  const std::string shown = quoted_text(file.string(), longest_path);
  if (!fs::is_regular_file(file, error)) {
    remarks.push_back(fmt::format("{} is not a file, so the defaults are used", shown));
    return std::nullopt;
  }
  const FileContents contents = file_contents(file);
  if (contents.error != 0) {
    remarks.push_back(fmt::format("{} cannot be read ({}), so the defaults are used; the file stays as it is", shown,
                                  unreadable_words(contents.error)));
    return std::nullopt;
  }
  TomlReader reader(file.string());
  Value value;
  // Unknown keys are those of a newer program, and missing ones those that an older one did not know.
  if (reader.parse(contents.text)) read(reader, value);
  const std::vector<ReadProblem> problems = reader.problems();
  if (problems.empty()) return value;

  std::string damage;
  for (const ReadProblem& problem : problems) {
    if (!damage.empty()) damage += "; ";
    if (problem.line > 0) damage += fmt::format("line {}: ", problem.line);
    damage += words_of({.what = problem.what, .remedy = problem.remedy});
  }
  const fs::path aside = name_aside(file);
  fs::rename(file, aside, error);
  remarks.push_back(error ? fmt::format("{} is damaged ({}), so the defaults are used", shown, damage)
                          : fmt::format("{} was damaged ({}) and is now {}; the defaults are used", shown, damage,
                                        quoted_text(aside.string(), longest_path)));
  return std::nullopt;
}

// `what` is kept in the file, for messages.
void write(const fs::path& file, const std::string& text, std::string_view what) {
  if (file.empty()) return;
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  if (error) {
    throw Failure(ExitCode::file_trouble,
                  fmt::format("the folder {} cannot be made: {}; {} kept there",
                              quoted_text(file.parent_path().string(), longest_path), error.message(), what));
  }
  // A link to nothing yet is followed; into a pipe nobody may ever look.
  if (const std::string_view kind = kind_instead_of_file(file); !kind.empty() && fs::exists(file, error)) {
    throw Failure(ExitCode::file_trouble, fmt::format("{} is {}, and {} kept in a file of this name; remove it",
                                                      quoted_text(file.string(), longest_path), kind, what));
  }
  // What cannot be read may be worth much all the same.
  const FileContents old = file_contents(file);
  if (old.error != 0 && old.error != ENOENT) {
    throw Failure(
        ExitCode::file_trouble,
        fmt::format("{} cannot be read ({}) and stays as it is, and {} kept in a file of this name; repair or "
                    "remove it",
                    quoted_text(file.string(), longest_path), std::generic_category().message(old.error), what));
  }
  OutputFile output(file.string());
  output.write(text);
  output.commit();
}

}  // namespace

StoredPreferences load_preferences() {
  StoredPreferences stored;
  stored.preferences = load_from<Preferences>(preferences_file(), stored.remarks).value_or(Preferences{});
  stored.layout = load_from<WindowLayout>(layout_file(), stored.remarks);
  return stored;
}

void save(const Preferences& preferences) {
  write(preferences_file(), text_of(preferences), "preferences are");
}

void save(const WindowLayout& layout) {
  write(layout_file(), text_of(layout), "the window's layout is");
}

}  // namespace ghostforce
