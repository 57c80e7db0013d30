// The sources as text, and the table of rooms, for the tests that compare them.
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/support/places.h"

namespace ghostforce {

// --- The table -------------------------------------------------------------------------------------------------------

struct Room {
  std::set<std::string> folders;    // that it may include, besides itself
  std::set<std::string> libraries;  // beyond the standard one
};

using Rooms = std::map<std::string, Room>;  // by folder, as in "app/workbench"

inline std::set<std::string> words_of(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

// Lines of "folder | folders | libraries". Throws std::runtime_error for any other line.
inline Rooms read_rooms(std::istream& lines) {
  Rooms rooms;
  std::string line;
  while (std::getline(lines, line)) {
    if (line.empty() || line.starts_with('#')) continue;
    static const std::regex row("([a-z_/]+) *\\|([a-z_/ ]*)\\|([a-z0-9_ ]*)");
    std::smatch cells;
    if (!std::regex_match(line, cells, row)) throw std::runtime_error("not a row of the table: " + line);
    if (!rooms.insert({cells[1], {words_of(cells[2]), words_of(cells[3])}}).second) {
      throw std::runtime_error("twice in the table: " + line);
    }
  }
  return rooms;
}

// What include lines of these libraries look like, with their quotes or brackets.
inline const std::map<std::string, std::regex>& library_includes() {
  static const std::map<std::string, std::regex> list{
      {"cairo", std::regex("<(cairo(/cairo)?[a-z-]*\\.h|ft2build\\.h|freetype/.+)>")},
      {"cli11", std::regex("<CLI/.+>")},
      {"emscripten", std::regex("<emscripten(/[a-z_0-9]+)?\\.h>")},  // the browser's side of a page
      {"fmt", std::regex("<fmt/.+>")},
      {"generated",
       std::regex("\"(embedded_[a-z_]+|ghostforce_build|ghostforce_version|ghostforce_paths)\\.h\"")},  // see cmake/
      {"glad", std::regex("<glad/e?gl\\.h>")},
      {"gles", std::regex("<GLES3/gl3\\.h>")},
      {"glfw", std::regex("<GLFW/.+>")},
      {"glm", std::regex("<glm/.+>")},
      {"hidapi", std::regex("<hidapi(/hidapi)?\\.h>")},
      {"imgui", std::regex("<imgui.*\\.h>")},
      {"implot", std::regex("<implot.*\\.h>")},
      {"libcrypto", std::regex("<openssl/.+>")},
      {"libsystemd", std::regex("<systemd/sd-bus\\.h>")},
      {"libpng", std::regex("<png\\.h>")},
      {"libusb", std::regex("<libusb(-1\\.0)?(/libusb)?\\.h>")},
      {"nlohmann_json", std::regex("<nlohmann/.+>")},
      {"opengl", std::regex("\"opengl\\.h\"")},  // each front's own: app/paint/
      // What the operating system offers beyond the standard library.
      {"posix", std::regex("<((sys|linux|netinet|arpa)/[a-z_0-9/]+|dirent|dlfcn|endian|errno|fcntl|malloc|poll|pthread|"
                           "sched|signal|spawn|stdio|stdlib|string|strings|syslog|termios|time|unistd)\\.h>")},
      {"stb", std::regex("<stb/.+>")},
      {"tomlplusplus", std::regex("<toml\\+\\+/.+>")},
      {"xcb", std::regex("<xcb/xcb\\.h>")},
      {"zlib", std::regex("<zlib\\.h>")},
  };
  return list;
}

// --- The sources -----------------------------------------------------------------------------------------------------

using Tree = std::map<std::string, std::string>;  // path from the root of the tree -> text

struct Include {
  int line;
  std::string operand;  // <vector> or "core/wall.h"; for anything else what stands there
};

inline std::vector<Include> includes_of(const std::string& text) {
  static const std::regex include_line("^\\s*#\\s*(include|import|include_next)\\b\\s*(<[^>]*>|\"[^\"]*\"|.*)");
  std::vector<Include> found;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::smatch match;
    if (std::regex_search(line, match, include_line)) found.push_back({number, match[2]});
  }
  return found;
}

inline std::optional<std::string> project_path(const std::string& operand) {
  if (operand.size() < 2 || operand.front() != '"') return {};
  return operand.substr(1, operand.size() - 2);
}

inline std::string folder_of(const std::string& path) {
  return std::filesystem::path(path).parent_path().generic_string();
}

inline Tree tree_at(const std::filesystem::path& root) {
  static const std::set<std::string> sources{".h", ".hpp", ".c", ".cpp", ".cc", ".inl", ".ipp"};
  Tree tree;
  for (const char* top : {"core", "device", "app"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / top)) {
      if (!entry.is_regular_file() || !sources.contains(entry.path().extension().string())) continue;
      std::ifstream file(entry.path());
      tree[entry.path().lexically_relative(root).generic_string()] =
          std::string(std::istreambuf_iterator<char>(file), {});
    }
  }
  return tree;
}

inline std::string listed(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  return text;
}

inline Rooms rooms_of_the_house() {
  std::ifstream file(source_path("/cmake/rooms.txt"));
  return read_rooms(file);
}

}  // namespace ghostforce
