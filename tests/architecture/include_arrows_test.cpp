// Who may include whom. Each room of the tree is listed with what its include lines may name; anything else is a
// forbidden arrow, and one convenient include is how a leak begins.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace {

// --- The rules -------------------------------------------------------------------------------------------------------

// <vector>, <cmath>: no dot, no slash.
const std::regex standard("<[a-z_0-9]+>");

// What the operating system offers beyond it.
const std::regex posix(
    "<((sys|linux|netinet|arpa)/[a-z_0-9/]+|"
    "dirent|dlfcn|endian|errno|fcntl|malloc|poll|pthread|sched|signal|spawn|stdio|"
    "stdlib|string|strings|syslog|termios|time|unistd)\\.h>");

// Made by the build, see cmake/.
const std::regex generated("\"(embedded_[a-z_]+|ghostforce_version|ghostforce_paths)\\.h\"");

struct Room {
  std::string folder;                        // ends in '/'; a file belongs to the longest folder that it lies in
  std::vector<std::regex> allowed;           // whole include operands, with their quotes or brackets
  std::vector<std::regex> refused;           // even where allowed
  std::optional<std::string> never_reaches;  // a folder that no chain of includes may lead to
};

std::vector<std::regex> regexes(std::initializer_list<const char*> patterns) {
  return {patterns.begin(), patterns.end()};
}

std::vector<std::regex> joined(std::vector<std::regex> a, const std::vector<std::regex>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

// design: core -> glm; device -> core and the libraries that reach hardware; app -> core, device and the libraries that
// reach a person. What is seen (view, paint, panels, figures) is made of snapshots and settings, never of a device.
const std::vector<Room>& rooms() {
  const std::vector<std::regex> pure = {standard, std::regex("\"core/.+\""), std::regex("<glm/.+>")};
  const std::vector<std::regex> words = regexes({"<fmt/.+>"});
  const std::vector<std::regex> files = regexes({"<toml\\+\\+/.+>", "<CLI/.+>", "<nlohmann/.+>", "<png\\.h>"});
  const std::vector<std::regex> gl = regexes({"<glad/gl\\.h>", "<GLFW/.+>"});
  const std::vector<std::regex> gui = regexes({"<imgui.*\\.h>", "<implot.*\\.h>"});
  const std::vector<std::regex> vector_pictures = regexes({"<cairo(/cairo)?[a-z-]*\\.h>", "<freetype/.+>"});
  const std::vector<std::regex> app = joined(pure, {std::regex("\"app/.+\""), generated});
  const std::vector<std::regex> seen = joined(joined(joined(app, words), files), joined(gui, vector_pictures));
  static const std::vector<Room> list{
      // Values and pure functions: no thread (atomics are values), no clock, no file, no stream.
      {"core/",
       pure,
       regexes({"<(thread|mutex|shared_mutex|condition_variable|future|semaphore|latch|barrier|stop_token)>",
                "<(chrono|ctime)>", "<(fstream|iostream|istream|ostream|sstream|syncstream|filesystem|cstdio)>"}),
       {}},
      {"device/",
       joined(pure, {std::regex("\"device/.+\""), posix, std::regex("<libusb(-1\\.0)?(/libusb)?\\.h>"),
                     std::regex("<libusb-1\\.0/libusb\\.h>"), std::regex("<hidapi(/hidapi)?\\.h>"),
                     std::regex("<openssl/.+>")}),
       {},
       {}},
      {"app/", joined(joined(seen, gl), {posix, std::regex("\"device/.+\"")}), {}, {}},
      // Marks are values: no library draws here.
      {"app/view/", joined(app, words), {}, "device/"},
      {"app/paint/", joined(seen, gl), {}, "device/"},
      {"app/panels/", joined(seen, gl), {}, "device/"},
      {"app/figures/", joined(seen, gl), {}, "device/"},
      {"app/chart/", joined(app, words), {}, "device/"},
      {"app/plots/", joined(seen, gl), {}, "device/"},
  };
  return list;
}

// --- Reading ---------------------------------------------------------------------------------------------------------

using Tree = std::map<std::string, std::string>;  // path from the root of the tree -> text

struct Include {
  int line;
  std::string operand;  // <vector> or "core/wall.h"; for anything else what stands there
};

std::vector<Include> includes_of(const std::string& text) {
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

std::optional<std::string> project_path(const std::string& operand) {
  if (operand.size() < 2 || operand.front() != '"') return {};
  return operand.substr(1, operand.size() - 2);
}

const Room* room_of(const std::string& path) {
  const Room* found = nullptr;
  for (const Room& room : rooms()) {
    if (path.starts_with(room.folder) && (!found || room.folder.size() > found->folder.size())) found = &room;
  }
  return found;
}

bool any_matches(const std::vector<std::regex>& patterns, const std::string& operand) {
  return std::any_of(patterns.begin(), patterns.end(),
                     [&](const std::regex& pattern) { return std::regex_match(operand, pattern); });
}

// The shortest chain of includes from a file into a folder, "a -> b -> c"; empty where there is none.
std::string chain_into(const Tree& tree, const std::string& from, const std::string& folder) {
  std::map<std::string, std::string> chains{{from, from}};
  std::vector<std::string> queue{from};
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const auto file = tree.find(queue[i]);
    if (file == tree.end()) continue;
    for (const Include& include : includes_of(file->second)) {
      const std::optional<std::string> next = project_path(include.operand);
      if (!next || chains.contains(*next)) continue;
      const std::string chain = chains[queue[i]] + " -> " + *next;
      if (next->starts_with(folder)) return chain;
      chains[*next] = chain;
      queue.push_back(*next);
    }
  }
  return {};
}

std::vector<std::string> forbidden_arrows(const Tree& tree) {
  std::vector<std::string> found;
  for (const auto& [path, text] : tree) {
    const Room* room = room_of(path);
    if (!room) continue;
    for (const Include& include : includes_of(text)) {
      if (!any_matches(room->allowed, include.operand) || any_matches(room->refused, include.operand)) {
        found.push_back(path + ':' + std::to_string(include.line) + ": " + room->folder + " may not include " +
                        include.operand);
      }
    }
    if (room->never_reaches) {
      const std::string chain = chain_into(tree, path, *room->never_reaches);
      if (!chain.empty()) found.push_back(chain + ": " + room->folder + " may not reach " + *room->never_reaches);
    }
  }
  return found;
}

Tree tree_at(const std::filesystem::path& root) {
  static const std::set<std::string> sources{".h", ".hpp", ".c", ".cpp", ".cc", ".inl", ".ipp"};
  Tree tree;
  for (const char* room : {"core", "device", "app"}) {
    if (!std::filesystem::exists(root / room)) continue;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / room)) {
      if (!entry.is_regular_file() || !sources.contains(entry.path().extension().string())) continue;
      std::ifstream file(entry.path());
      tree[entry.path().lexically_relative(root).generic_string()] =
          std::string(std::istreambuf_iterator<char>(file), {});
    }
  }
  return tree;
}

std::string listed(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  return text;
}

// --- The tree --------------------------------------------------------------------------------------------------------

TEST(IncludeArrowsTest, NoneIsForbidden) {
  const Tree tree = tree_at(GHOSTFORCE_SOURCE_DIR);
  ASSERT_TRUE(tree.contains("core/conventions.h")) << "the tree was not read";
  const std::vector<std::string> found = forbidden_arrows(tree);
  EXPECT_TRUE(found.empty()) << listed(found);
}

// "core/wall.h", not "wall.h" and not "../core/wall.h": an include line shows which room it reaches into, and names a
// file that is there.
TEST(IncludeArrowsTest, QuotedIncludesNameFilesFromTheRoot) {
  const Tree tree = tree_at(GHOSTFORCE_SOURCE_DIR);
  for (const auto& [path, text] : tree) {
    for (const Include& include : includes_of(text)) {
      const std::optional<std::string> target = project_path(include.operand);
      if (!target || std::regex_match(include.operand, generated)) continue;
      EXPECT_TRUE(tree.contains(*target)) << path << ':' << include.line << ": " << include.operand;
    }
  }
}

// --- The test itself: it must be able to fail ------------------------------------------------------------------------

TEST(IncludeArrowsSelfTest, RefusesWhatEachRoomMayNotSee) {
  const std::vector<std::pair<std::string, std::string>> forbidden{
      {"core/a.h", "#include <GLFW/glfw3.h>"},
      {"core/a.h", "#include <imgui.h>"},
      {"core/a.h", "#include <Eigen/Dense>"},
      {"core/a.h", "#include <fmt/core.h>"},
      {"core/a.h", "#include <thread>"},
      {"core/a.h", "#include <chrono>"},
      {"core/a.h", "#include <fstream>"},
      {"core/a.h", "#include <unistd.h>"},
      {"core/a.h", "#include \"device/servo/servo.h\""},
      {"core/a.h", "#include \"app/ui/window.h\""},
      {"core/a.h", "#include \"wall.h\""},
      {"core/a.h", "#include \"../device/servo.h\""},
      {"core/a.h", "  #  include\t<GLFW/glfw3.h>  // convenient"},
      {"core/deep/a.cpp", "#include <GL/gl.h>"},
      {"core/a.cpp", "#include SOME_HEADER"},
      {"device/a.cpp", "#include \"app/ui/window.h\""},
      {"device/a.cpp", "#include <imgui.h>"},
      {"device/a.cpp", "#include <toml++/toml.h>"},
      {"device/falcon/a.cpp", "#include <GLFW/glfw3.h>"},
      {"app/a.cpp", "#include <libusb-1.0/libusb.h>"},
      {"app/a.cpp", "#include <libusb.h>"},
      {"app/a.cpp", "#include <hidapi.h>"},
      {"app/a.cpp", "#include <hidapi/hidapi.h>"},
      {"app/a.cpp", "#include <Eigen/Dense>"},
      {"app/a.cpp", "#include <gtest/gtest.h>"},
      {"app/a.cpp", "#include \"tests/support/program.h\""},
      {"app/view/a.cpp", "#include \"device/servo/servo.h\""},
      {"app/view/a.cpp", "#include <imgui.h>"},
      {"app/view/a.cpp", "#include <unistd.h>"},
      {"app/paint/gl/a.cpp", "#include \"device/servo/servo.h\""},
      {"app/panels/a.cpp", "#include \"device/servo/servo.h\""},
      {"app/figures/a.cpp", "#include \"device/input/input.h\""},
  };
  for (const auto& [path, line] : forbidden) {
    const std::vector<std::string> found = forbidden_arrows({{path, "#pragma once\n" + line + "\n"}});
    ASSERT_FALSE(found.empty()) << path << ": " << line;
    EXPECT_TRUE(found[0].starts_with(path)) << found[0];
  }
}

TEST(IncludeArrowsSelfTest, LetsThroughWhatEachRoomNeeds) {
  const Tree fine{
      {"core/a.h", "#include <atomic>\n#include <glm/vec2.hpp>\n#include \"core/b.h\"\n"},
      {"device/a.cpp",
       "#include <thread>\n#include <pthread.h>\n#include <sys/mman.h>\n#include <libusb-1.0/libusb.h>\n"
       "#include <libusb.h>\n#include <linux/usbdevice_fs.h>\n#include <hidapi.h>\n"
       "#include <hidapi/hidapi.h>\n#include <openssl/sha.h>\n"
       "#include \"core/b.h\"\n#include \"device/b.h\"\n"},
      {"app/a.cpp",
       "#include <unistd.h>\n#include <GLFW/glfw3.h>\n#include <glad/gl.h>\n#include <imgui_impl_glfw.h>\n"
       "#include <implot.h>\n#include <toml++/toml.h>\n#include <CLI/CLI.hpp>\n#include <fmt/core.h>\n"
       "#include <nlohmann/json.hpp>\n#include <png.h>\n#include \"device/servo/servo.h\"\n"
       "#include \"embedded_shaders.h\"\n#include \"ghostforce_version.h\"\n"},
      {"app/view/a.cpp", "#include \"core/snapshot.h\"\n#include \"app/view/theme.h\"\n#include <fmt/format.h>\n"},
      {"app/paint/a.cpp",
       "#include <cairo/cairo-svg.h>\n#include <cairo.h>\n#include <freetype/freetype.h>\n"
       "#include <glad/gl.h>\n"},
      {"app/panels/a.cpp", "#include <imgui.h>\n#include <implot.h>\n"},
      {"core/comment.h", "// #include <imgui.h> would be a leak\n"},
      {"tests/a.cpp", "#include <Eigen/Dense>\n#include <gtest/gtest.h>\n"},
  };
  EXPECT_EQ(listed(forbidden_arrows(fine)), "");
}

// A detour is an arrow too.
TEST(IncludeArrowsSelfTest, FollowsChainsFromThePictureToTheDevice) {
  const Tree detour{
      {"app/ui/widgets/panel_context.h", "#include \"app/session/session.h\"\n"},
      {"app/session/session.h", "#include \"app/hub.h\"\n"},
      {"app/hub.h", "#include \"device/servo/servo.h\"\n"},
      {"device/servo/servo.h", "\n"},
  };
  const std::vector<std::string> found = forbidden_arrows(detour);
  ASSERT_EQ(found.size(), 1U) << listed(found);
  EXPECT_TRUE(found[0].starts_with(
      "app/ui/widgets/panel_context.h -> app/session/session.h -> app/hub.h -> device/servo/servo.h"))
      << found[0];
}

TEST(IncludeArrowsSelfTest, SaysWhere) {
  const std::vector<std::string> found = forbidden_arrows({{"core/a.h", "#pragma once\n\n#include <imgui.h>\n"}});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0], "core/a.h:3: core/ may not include <imgui.h>");
}

}  // namespace
