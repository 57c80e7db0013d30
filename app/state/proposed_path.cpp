#include "app/state/proposed_path.h"

#include <cctype>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>

#include "app/files/file_exchange.h"

namespace ghostforce {

namespace fs = std::filesystem;

std::string file_stem(std::string_view title) {
  std::string stem;
  for (const char c : title) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80 && std::isalnum(byte) != 0) {
      stem += static_cast<char>(std::tolower(byte));
    } else if (!stem.empty() && stem.back() != '-') {
      stem += '-';
    }
  }
  while (!stem.empty() && stem.back() == '-') stem.pop_back();
  constexpr std::size_t longest = 60;
  return stem.empty() ? "scene" : stem.substr(0, longest);
}

std::string proposed_path(std::string_view stem, std::string_view extension) {
  std::error_code error;
  const fs::path folder = save_place().has_folders ? fs::current_path(error) : fs::path();
  for (int number = 1;; ++number) {
    const std::string name =
        number == 1 ? fmt::format("{}.{}", stem, extension) : fmt::format("{}-{}.{}", stem, number, extension);
    if (const fs::path path = folder / name; !fs::exists(path, error)) return path.string();
  }
}

std::string proposed_path(const Session& session, Dialog dialog) {
  const std::string stem = file_stem(session.scene->title);
  switch (dialog) {
    case Dialog::save_scene:
      return proposed_path(stem, "ghostforce.toml");
    case Dialog::save_picture:
      return proposed_path(fmt::format("{}-{}", stem, strategy(session.settings.active).name), "png");
    case Dialog::save_clip:
      return proposed_path(stem + "-clip", "png");
    case Dialog::save_plots:
      return proposed_path(fmt::format("{}-{}", stem, plot_tab_name(session.plots.tab)), "csv");
    default:
      return {};
  }
}

}  // namespace ghostforce
