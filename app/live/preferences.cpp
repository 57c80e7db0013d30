#include "app/live/preferences.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <span>

#include <fmt/format.h>

#include "app/files/kept_file.h"
#include "app/files/toml_document.h"
#include "app/files/xdg_folders.h"
#include "app/ui/window.h"

namespace ghostforce {
namespace {

namespace fs = std::filesystem;

KeptFile preferences_file() {
  const fs::path where = config_folder();
  return {.path = where.empty() ? where : where / "preferences.toml", .contents = "preferences are"};
}

KeptFile layout_file() {
  const fs::path where = state_folder();
  return {.path = where.empty() ? where : where / "layout.toml", .contents = "the window's layout is"};
}

// Unknown keys are those of a newer program, and missing ones those that an older one did not know.
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

}  // namespace

StoredPreferences load_preferences() {
  StoredPreferences stored;
  Preferences preferences;
  if (load(
          preferences_file(), [&](TomlReader& reader) { read(reader, preferences); }, stored.remarks)) {
    stored.preferences = preferences;
  }
  WindowLayout layout;
  if (load(
          layout_file(), [&](TomlReader& reader) { read(reader, layout); }, stored.remarks))
    stored.layout = layout;
  return stored;
}

void save(const Preferences& preferences) {
  save(preferences_file(), text_of(preferences));
}

void save(const WindowLayout& layout) {
  save(layout_file(), text_of(layout));
}

}  // namespace ghostforce
