// Who may include whom: the include lines of the sources against the table that the libraries are linked by
// (cmake/rooms.txt). Anything that is not in the table is a forbidden arrow, and one convenient include is how a leak
// begins. The table itself may hold no ring: folders that include each other are one folder in disguise.

#include <algorithm>
#include <cstddef>
#include <iostream>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/architecture/source_tree.h"
#include "tests/support/places.h"

namespace ghostforce::rooms_test {
namespace {

// --- What is found ---------------------------------------------------------------------------------------------------

// <vector>, <cmath>: no dot, no slash. core has values and pure functions: no thread (atomics are values), no clock, no
// file, no stream.
bool is_standard(const std::string& operand, const std::string& folder) {
  static const std::regex standard("<[a-z_0-9]+>");
  static const std::regex impure(
      "<(thread|mutex|shared_mutex|condition_variable|future|semaphore|latch|barrier|stop_token|chrono|ctime|fstream|"
      "iostream|istream|ostream|sstream|syncstream|filesystem|cstdio)>");
  return std::regex_match(operand, standard) && !(folder == "core" && std::regex_match(operand, impure));
}

bool may_include(const Rooms& rooms, const std::string& folder, const std::string& operand) {
  const Room& room = rooms.at(folder);
  if (is_standard(operand, folder)) return true;
  for (const std::string& library : room.libraries) {
    if (std::regex_match(operand, library_includes().at(library))) return true;
  }
  const std::optional<std::string> path = project_path(operand);
  if (!path) return false;
  const std::string target = folder_of(*path);
  return target == folder || room.folders.contains(target);
}

std::vector<std::string> forbidden_arrows(const Rooms& rooms, const Tree& tree) {
  std::vector<std::string> found;
  for (const auto& [path, text] : tree) {
    const std::string folder = folder_of(path);
    if (!rooms.contains(folder)) {
      found.push_back(path + ": " + folder + " has no line in cmake/rooms.txt");
      continue;
    }
    for (const Include& include : includes_of(text)) {
      if (may_include(rooms, folder, include.operand)) continue;
      found.push_back(path + ':' + std::to_string(include.line) + ": " + folder + " may not include " +
                      include.operand);
    }
  }
  return found;
}

// The arrows that the table allows and no include line uses.
std::vector<std::string> unused_arrows(const Rooms& rooms, const Tree& tree) {
  Rooms unused = rooms;
  for (const auto& [path, text] : tree) {
    const auto room = unused.find(folder_of(path));
    if (room == unused.end()) continue;
    for (const Include& include : includes_of(text)) {
      std::erase_if(room->second.libraries, [&](const std::string& library) {
        return std::regex_match(include.operand, library_includes().at(library));
      });
      if (const auto target = project_path(include.operand)) room->second.folders.erase(folder_of(*target));
    }
  }
  std::vector<std::string> found;
  for (const auto& [folder, room] : unused) {
    for (const std::string& target : room.folders) found.push_back(folder + " uses nothing of " + target);
    for (const std::string& library : room.libraries) found.push_back(folder + " uses nothing of " + library);
  }
  return found;
}

using Arrows = std::map<std::string, std::set<std::string>>;

// From folder to folder, as the include lines have it.
Arrows folder_arrows(const Tree& tree) {
  Arrows arrows;
  for (const auto& [path, text] : tree) {
    std::set<std::string>& targets = arrows[folder_of(path)];
    for (const Include& include : includes_of(text)) {
      const std::optional<std::string> target = project_path(include.operand);
      if (target && tree.contains(*target) && folder_of(*target) != folder_of(path)) targets.insert(folder_of(*target));
    }
  }
  return arrows;
}

// From file to file; a header and its source are one.
Arrows file_arrows(const Tree& tree) {
  const auto stem = [](const std::string& path) { return path.substr(0, path.rfind('.')); };
  Arrows arrows;
  for (const auto& [path, text] : tree) {
    std::set<std::string>& targets = arrows[stem(path)];
    for (const Include& include : includes_of(text)) {
      const std::optional<std::string> target = project_path(include.operand);
      if (target && tree.contains(*target) && stem(*target) != stem(path)) targets.insert(stem(*target));
    }
  }
  return arrows;
}

// One of the rings in which arrows lead back to where they began, "a -> b -> a"; empty: there is none.
std::string ring_in(const Arrows& arrows) {
  std::set<std::string> done;
  for (const auto& [start, unused] : arrows) {
    std::vector<std::string> way;
    const auto visit = [&](const auto& self, const std::string& here) -> std::string {
      const auto before = std::find(way.begin(), way.end(), here);
      if (before != way.end()) {
        std::string ring;
        for (auto step = before; step != way.end(); ++step) ring += *step + " -> ";
        return ring + here;
      }
      const auto targets = arrows.find(here);
      if (targets == arrows.end() || done.contains(here)) return {};
      way.push_back(here);
      for (const std::string& target : targets->second) {
        if (std::string ring = self(self, target); !ring.empty()) return ring;
      }
      way.pop_back();
      done.insert(here);
      return {};
    };
    if (std::string ring = visit(visit, start); !ring.empty()) return ring;
  }
  return {};
}

// --- The house -------------------------------------------------------------------------------------------------------

TEST(RoomsTest, NoArrowIsForbidden) {
  const Tree tree = tree_at(source_path());
  ASSERT_TRUE(tree.contains("core/conventions.h")) << "the tree was not read";
  EXPECT_EQ(listed(forbidden_arrows(rooms_of_the_house(), tree)), "");
}

TEST(RoomsTest, NoArrowIsAllowedInVain) {
  EXPECT_EQ(listed(unused_arrows(rooms_of_the_house(), tree_at(source_path()))), "");
}

TEST(RoomsTest, NoFoldersIncludeEachOtherInARing) {
  const Arrows arrows = folder_arrows(tree_at(source_path()));
  std::size_t count = 0;
  for (const auto& [from, targets] : arrows) {
    count += targets.size();
    std::cout << from << " ->";
    for (const std::string& target : targets) std::cout << ' ' << target;
    std::cout << '\n';
  }
  const std::string ring = ring_in(arrows);
  std::cout << arrows.size() << " folders, " << count << " arrows, " << (ring.empty() ? "no ring" : ring) << '\n';
  EXPECT_EQ(ring, "");
}

TEST(RoomsTest, NoFilesIncludeEachOtherInARing) {
  EXPECT_EQ(ring_in(file_arrows(tree_at(source_path()))), "");
}

// What nobody includes today somebody could include tomorrow.
TEST(RoomsTest, TheTableAllowsNoRing) {
  const Rooms rooms = rooms_of_the_house();
  Arrows arrows;
  for (const auto& [folder, room] : rooms) arrows[folder] = room.folders;
  EXPECT_EQ(ring_in(arrows), "");
}

TEST(RoomsTest, TheTableNamesFoldersAndLibrariesThatAreThere) {
  const Rooms rooms = rooms_of_the_house();
  ASSERT_TRUE(rooms.contains("core"));
  const Tree tree = tree_at(source_path());
  for (const auto& [folder, room] : rooms) {
    EXPECT_TRUE(std::any_of(tree.begin(), tree.end(),
                            [&, &name = folder](const auto& file) { return folder_of(file.first) == name; }))
        << folder << " has no sources";
    for (const std::string& target : room.folders) EXPECT_TRUE(rooms.contains(target)) << folder << ": " << target;
    for (const std::string& library : room.libraries) {
      EXPECT_TRUE(library_includes().contains(library)) << folder << ": " << library;
    }
  }
}

// "core/wall.h", not "wall.h" and not "../core/wall.h": an include line shows which room it reaches into, and names a
// file that is there.
TEST(RoomsTest, QuotedIncludesNameFilesFromTheRoot) {
  const Tree tree = tree_at(source_path());
  for (const auto& [path, text] : tree) {
    for (const Include& include : includes_of(text)) {
      const std::optional<std::string> target = project_path(include.operand);
      const auto is_of = [&](const char* library) {
        return std::regex_match(include.operand, library_includes().at(library));
      };
      if (!target || is_of("generated") || is_of("opengl")) continue;
      EXPECT_TRUE(tree.contains(*target)) << path << ':' << include.line << ": " << include.operand;
    }
  }
}

// --- The test itself: it must be able to fail ------------------------------------------------------------------------

TEST(RoomsSelfTest, RefusesWhatARoomMayNotSee) {
  const Rooms rooms = rooms_of_the_house();
  const std::vector<std::pair<std::string, std::string>> forbidden{
      {"core/a.h", "#include <GLFW/glfw3.h>"},
      {"core/a.h", "#include <Eigen/Dense>"},
      {"core/a.h", "#include <fmt/core.h>"},
      {"core/a.h", "#include <thread>"},
      {"core/a.h", "#include <chrono>"},
      {"core/a.h", "#include <fstream>"},
      {"core/a.h", "#include <unistd.h>"},
      {"core/a.h", "#include \"device/servo/servo.h\""},
      {"core/a.h", "#include \"wall.h\""},
      {"core/a.h", "#include \"../device/servo/servo.h\""},
      {"core/a.h", "  #  include\t<GLFW/glfw3.h>  // convenient"},
      {"core/a.cpp", "#include SOME_HEADER"},
      {"core/deep/a.cpp", "#include <vector>"},
      {"device/input/a.cpp", "#include \"device/servo/servo.h\""},
      {"device/servo/a.cpp", "#include \"device/falcon/falcon.h\""},
      {"device/servo/a.cpp", "#include <libusb.h>"},
      {"device/falcon/a.cpp", "#include \"device/falcon_usb/ftdi_link.h\""},
      {"device/falcon/a.cpp", "#include <libusb-1.0/libusb.h>"},
      {"device/input/a.cpp", "#include \"app/shell/window.h\""},
      {"app/picture/a.cpp", "#include \"device/servo/servo.h\""},
      {"app/picture/a.cpp", "#include <imgui.h>"},
      {"app/base/a.cpp", "#include \"core/wall.h\""},
      {"app/files/a.cpp", "#include \"app/runs/recording.h\""},
      {"app/paint/a.cpp", "#include \"app/paint/vector/vector_painter.h\""},
      {"app/paint/a.cpp", "#include <cairo.h>"},
      {"app/paint/a.cpp", "#include <glad/gl.h>"},
      {"app/paint/a.cpp", "#include <GLES3/gl3.h>"},
      {"app/state/a.cpp", "#include \"device/input/mouse_input.h\""},
      {"app/state/a.cpp", "#include \"app/tools/doctor/readiness.h\""},
      {"app/state/a.cpp", "#include <imgui.h>"},
      {"app/state/a.cpp", "#include <GLFW/glfw3.h>"},
      {"app/widgets/a.cpp", "#include \"app/workbench/panel_catalog.h\""},
      {"app/workbench/a.cpp", "#include \"app/shell/window.h\""},
      {"app/state/a.cpp", "#include \"app/stage/stage.h\""},
      {"app/shell/a.cpp", "#include <GLFW/glfw3.h>"},
      {"app/shell/a.cpp", "#include <unistd.h>"},
      {"app/shell/a.cpp", "#include \"app/shell/desktop/glfw_window.h\""},
      {"app/stage/a.cpp", "#include \"app/workbench/dialogs.h\""},
      {"app/shell/a.cpp", "#include \"device/falcon_usb/ftdi_link.h\""},
      {"app/shell/a.cpp", "#include \"app/cli/command.h\""},
      {"app/tools/check/a.cpp", "#include <gtest/gtest.h>"},
      {"app/cli/a.cpp", "#include \"tests/support/program.h\""},
      {"app/nowhere/a.cpp", "#include <vector>"},
  };
  for (const auto& [path, line] : forbidden) {
    const std::vector<std::string> found = forbidden_arrows(rooms, {{path, "#pragma once\n" + line + "\n"}});
    ASSERT_FALSE(found.empty()) << path << ": " << line;
    EXPECT_TRUE(found[0].starts_with(path)) << found[0];
  }
}

TEST(RoomsSelfTest, LetsThroughWhatEachRoomNeeds) {
  const Tree fine{
      {"core/a.h", "#include <atomic>\n#include <glm/vec2.hpp>\n#include \"core/b.h\"\n"},
      {"device/servo/a.cpp", "#include <thread>\n#include <pthread.h>\n#include \"device/input/b.h\"\n"},
      {"device/falcon_usb/a.cpp", "#include <libusb.h>\n#include <sys/mman.h>\n#include <openssl/sha.h>\n"},
      {"app/picture/a.cpp",
       "#include \"core/snapshot.h\"\n#include \"app/picture/theme.h\"\n#include <fmt/format.h>\n"},
      {"app/paint/vector/a.cpp", "#include <cairo/cairo-svg.h>\n#include <freetype/freetype.h>\n"},
      {"app/workbench/a.cpp", "#include <implot.h>\n#include \"app/workbench/b.h\"\n"},
      {"core/comment.h", "// #include <imgui.h> would be a leak\n"},
  };
  EXPECT_EQ(listed(forbidden_arrows(rooms_of_the_house(), fine)), "");
}

TEST(RoomsSelfTest, SaysWhere) {
  EXPECT_EQ(listed(forbidden_arrows(rooms_of_the_house(), {{"core/a.h", "#pragma once\n\n#include <imgui.h>\n"}})),
            "core/a.h:3: core may not include <imgui.h>\n");
}

TEST(RoomsSelfTest, SeesWhatIsAllowedAndNotUsed) {
  const Rooms rooms{{"app/shell", {.folders = {"core", "app/picture"}, .libraries = {"fmt", "imgui"}}}};
  const Tree tree{{"app/shell/a.cpp", "#include \"core/b.h\"\n#include <imgui.h>\n"}};
  EXPECT_EQ(listed(unused_arrows(rooms, tree)),
            "app/shell uses nothing of app/picture\napp/shell uses nothing of fmt\n");
}

TEST(RoomsSelfTest, SeesARingOfFolders) {
  const Tree ring{
      {"app/picture/a.h", "#include \"app/picture/b.h\"\n"},
      {"app/picture/b.h", "#include \"core/c.h\"\n#include \"app/widgets/d.h\"\n"},
      {"app/widgets/d.h", "#include \"app/workbench/e.h\"\n"},
      {"app/workbench/e.h", "#include \"app/picture/f.h\"\n"},
      {"app/picture/f.h", "\n"},
      {"core/c.h", "\n"},
  };
  EXPECT_EQ(ring_in(folder_arrows(ring)), "app/picture -> app/widgets -> app/workbench -> app/picture");
  EXPECT_EQ(ring_in(file_arrows(ring)), "");
}

// A folder and one inside it are two.
TEST(RoomsSelfTest, SeesARingOfAFolderAndItsSubFolder) {
  const Tree ring{
      {"app/paint/window.h", "#include \"app/paint/vector/style.h\"\n"},
      {"app/paint/vector/style.h", "#include \"app/paint/fonts.h\"\n"},
      {"app/paint/fonts.h", "\n"},
  };
  EXPECT_EQ(ring_in(folder_arrows(ring)), "app/paint -> app/paint/vector -> app/paint");
}

TEST(RoomsSelfTest, SeesTwoHeadersThatNeedEachOther) {
  const Tree pair{
      {"core/tick.h", "\n"},
      {"core/tick.cpp", "#include \"core/tick.h\"\n#include \"core/tick_strategy.h\"\n"},
      {"core/tick_strategy.h", "#include \"core/tick.h\"\n"},
  };
  EXPECT_EQ(ring_in(file_arrows(pair)), "core/tick -> core/tick_strategy -> core/tick");
}

TEST(RoomsSelfTest, RefusesATableThatIsNone) {
  for (const char* const text : {"core glm\n", "core | glm\n", "core || glm |\n", "core || glm\ncore ||\n"}) {
    std::istringstream lines(text);
    EXPECT_THROW(read_rooms(lines), std::runtime_error) << text;
  }
}

}  // namespace
}  // namespace ghostforce::rooms_test
