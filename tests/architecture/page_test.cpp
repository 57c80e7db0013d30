// What the page in a browser is made of. It has no threads, signals, processes and sockets, and some libraries are the
// desktop's alone: what is compiled for it may not include them, nor by a header. That is the sources of its rooms but
// those that their CMakeLists.txt lists as DESKTOP, and all headers that these lead to.

#include <algorithm>
#include <array>
#include <deque>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/architecture/source_tree.h"
#include "tests/support/places.h"

namespace ghostforce::page_test {
namespace {

constexpr std::array desktop_libraries{"cairo", "cli11", "glfw", "hidapi", "libcrypto", "libsystemd", "libusb", "xcb"};

bool is_for_desktop_alone(const std::string& operand) {
  static const std::regex system(
      "<(thread|mutex|condition_variable|future|semaphore|stop_token|shared_mutex|latch|barrier|pthread\\.h|sched\\.h|"
      "csignal|signal\\.h|spawn\\.h|sys/(wait|socket|prctl|syscall)\\.h|poll\\.h|dlfcn\\.h)>");
  return std::regex_match(operand, system) || std::ranges::any_of(desktop_libraries, [&](const char* library) {
           return std::regex_match(operand, library_includes().at(library));
         });
}

// The rooms that the page's own leads to; before there is one, what it will show.
std::set<std::string> rooms_of_the_page(const Rooms& rooms) {
  std::deque<std::string> next{rooms.contains("app/shell/web") ? "app/shell/web" : "app/shell"};
  std::set<std::string> found;
  for (; !next.empty(); next.pop_front()) {
    if (!found.insert(next.front()).second) continue;
    const std::set<std::string>& folders = rooms.at(next.front()).folders;
    next.insert(next.end(), folders.begin(), folders.end());
  }
  return found;
}

// By folder, the text of its CMakeLists.txt.
using Lists = std::map<std::string, std::string>;

Lists lists_at(const std::filesystem::path& root, const std::set<std::string>& folders) {
  Lists lists;
  for (const std::string& folder : folders) {
    std::ifstream file(root / folder / "CMakeLists.txt");
    lists[folder] = std::string(std::istreambuf_iterator<char>(file), {});
  }
  return lists;
}

// What stands after such a word, SOURCES, DESKTOP or PAGE, in ghostforce_add_room().
std::set<std::string> sources_after(const std::string& keyword, const std::string& list) {
  std::string call = std::regex_replace(list, std::regex("#[^\n]*"), "");
  const std::size_t begin = call.find("ghostforce_add_room(");
  if (begin == std::string::npos) return {};
  call = call.substr(call.find('(', begin) + 1);
  std::istringstream words(call.substr(0, call.find(')')));
  std::set<std::string> sources;
  std::string word;
  for (bool is_inside = false; words >> word;) {
    if (word == "SOURCES" || word == "DESKTOP" || word == "PAGE" || word == "SEPARATE") {
      is_inside = word == keyword;
    } else if (is_inside) {
      sources.insert(word);
    }
  }
  return sources;
}

// The sources that are compiled for the page, and the headers that they lead to.
std::set<std::string> compiled_for_the_page(const Tree& tree, const Lists& lists) {
  std::deque<std::string> next;
  for (const auto& [folder, list] : lists) {
    for (const char* const keyword : {"SOURCES", "PAGE"}) {
      for (const std::string& source : sources_after(keyword, list)) {
        if (std::string path = folder + '/' + source; tree.contains(path)) next.push_back(std::move(path));
      }
    }
  }
  std::set<std::string> found;
  for (; !next.empty(); next.pop_front()) {
    if (!found.insert(next.front()).second) continue;
    for (const Include& include : includes_of(tree.at(next.front()))) {
      const std::optional<std::string> target = project_path(include.operand);
      if (target && tree.contains(*target)) next.push_back(*target);
    }
  }
  return found;
}

// What the page's rooms include that it cannot have; and what it alone has, outside the sources that are its own.
std::vector<std::string> problems_of_the_page(const Tree& tree, const Lists& lists) {
  std::vector<std::string> found;
  for (const std::string& path : compiled_for_the_page(tree, lists)) {
    const auto list = lists.find(folder_of(path));
    const std::string name = std::filesystem::path(path).filename().string();
    const bool is_its_own = list != lists.end() && sources_after("PAGE", list->second).contains(name);
    for (const Include& include : includes_of(tree.at(path))) {
      const bool is_for_page_alone = std::regex_match(include.operand, library_includes().at("emscripten"));
      if (!is_for_desktop_alone(include.operand) && (!is_for_page_alone || is_its_own)) continue;
      found.push_back(path + ':' + std::to_string(include.line) + ": " + include.operand + " is for the " +
                      (is_for_page_alone ? "page" : "desktop") + " alone");
    }
  }
  return found;
}

// --- The house -------------------------------------------------------------------------------------------------------

TEST(PageTest, IncludesNothingThatABrowserLacks) {
  const Tree tree = tree_at(source_path());
  const std::set<std::string> rooms = rooms_of_the_page(rooms_of_the_house());
  for (const char* const room : {"core", "device/servo", "app/files", "app/workbench"}) {
    EXPECT_TRUE(rooms.contains(room)) << room;
  }
  EXPECT_FALSE(rooms.contains("app/cli"));
  const Lists lists = lists_at(source_path(), rooms);
  const std::set<std::string> compiled = compiled_for_the_page(tree, lists);
  ASSERT_TRUE(compiled.contains("app/files/kept_file_page.cpp")) << "the lists were not read";
  ASSERT_TRUE(compiled.contains("app/runs/recording.h")) << "headers were not followed";
  EXPECT_FALSE(compiled.contains("app/base/worker.cpp"));
  EXPECT_EQ(listed(problems_of_the_page(tree, lists)), "");
}

// One behind which nothing stands would be found by the linker, and only by who builds the page.
TEST(PageTest, BehindAHeaderStandsOneForEachFront) {
  std::set<std::string> shared = rooms_of_the_page(rooms_of_the_house());
  shared.erase("app/shell/web");  // the page's own front
  for (const auto& [folder, list] : lists_at(source_path(), shared)) {
    const std::set<std::string> desktop = sources_after("DESKTOP", list);
    for (const std::string& source : sources_after("PAGE", list)) {
      const std::size_t end = source.find("_page.cpp");
      ASSERT_NE(end, std::string::npos) << folder << '/' << source;
      EXPECT_TRUE(desktop.contains(source.substr(0, end) + ".cpp")) << folder << '/' << source;
    }
  }
}

// --- The test itself: it must be able to fail ------------------------------------------------------------------------

const Lists one_room{{"app/runs",
                      "ghostforce_add_room(\n  SOURCES\n    a.cpp  # b.cpp\n  DESKTOP c.cpp\n  PAGE\n"
                      "    c_page.cpp)\nembed_text_files(d.cpp)\n"}};

TEST(PageSelfTest, ReadsWhichSourcesAreWhose) {
  const std::string& list = one_room.at("app/runs");
  EXPECT_EQ(sources_after("SOURCES", list), (std::set<std::string>{"a.cpp"}));
  EXPECT_EQ(sources_after("DESKTOP", list), (std::set<std::string>{"c.cpp"}));
  EXPECT_EQ(sources_after("PAGE", list), (std::set<std::string>{"c_page.cpp"}));
}

TEST(PageSelfTest, RefusesWhatABrowserLacks) {
  for (const char* const operand : {"<thread>",
                                    "<mutex>",
                                    "<condition_variable>",
                                    "<future>",
                                    "<semaphore>",
                                    "<stop_token>",
                                    "<shared_mutex>",
                                    "<latch>",
                                    "<barrier>",
                                    "<pthread.h>",
                                    "<sched.h>",
                                    "<csignal>",
                                    "<signal.h>",
                                    "<spawn.h>",
                                    "<sys/wait.h>",
                                    "<sys/socket.h>",
                                    "<sys/prctl.h>",
                                    "<sys/syscall.h>",
                                    "<poll.h>",
                                    "<dlfcn.h>",
                                    "<libusb.h>",
                                    "<hidapi.h>",
                                    "<cairo/cairo-pdf.h>",
                                    "<openssl/sha.h>",
                                    "<CLI/CLI.hpp>",
                                    "<GLFW/glfw3.h>"}) {
    const std::string line = std::string("#include ") + operand + '\n';
    for (const char* const source : {"app/runs/a.cpp", "app/runs/c_page.cpp"}) {
      EXPECT_EQ(problems_of_the_page({{source, line}}, one_room).size(), 1U) << source << ' ' << operand;
    }
    EXPECT_EQ(listed(problems_of_the_page({{"app/runs/c.cpp", line}}, one_room)), "") << operand;
  }
  for (const char* const operand :
       {"<atomic>", "<chrono>", "<filesystem>", "<unistd.h>", "<sys/stat.h>", "<fcntl.h>"}) {
    const Tree fine{{"app/runs/a.cpp", std::string("#include ") + operand + '\n'}};
    EXPECT_EQ(listed(problems_of_the_page(fine, one_room)), "");
  }
}

TEST(PageSelfTest, SeesWhatAHeaderBringsAndWhere) {
  Tree tree{{"app/runs/a.cpp", "#include \"app/runs/a.h\"\n"},
            {"app/runs/a.h", "#include \"core/deep.h\"\n"},
            {"core/deep.h", "#pragma once\n#include <mutex>\n"}};
  EXPECT_EQ(listed(problems_of_the_page(tree, one_room)), "core/deep.h:2: <mutex> is for the desktop alone\n");
  // A header that only the desktop's own sources include is the desktop's own.
  tree["app/runs/c.cpp"] = tree.extract("app/runs/a.cpp").mapped();
  EXPECT_EQ(listed(problems_of_the_page(tree, one_room)), "");
}

TEST(PageSelfTest, WhatOnlyAPageHasIsForItsOwnSources) {
  const std::string line = "#include <emscripten.h>\n";
  EXPECT_EQ(listed(problems_of_the_page({{"app/runs/a.cpp", line}}, one_room)),
            "app/runs/a.cpp:1: <emscripten.h> is for the page alone\n");
  EXPECT_EQ(listed(problems_of_the_page({{"app/runs/c_page.cpp", line}}, one_room)), "");
}

TEST(PageSelfTest, FollowsTheTableToTheLastRoom) {
  const Rooms rooms{
      {"app/shell/web", {{"app/picture"}, {}}}, {"app/picture", {{"core"}, {}}}, {"core", {}}, {"app/shell", {}}};
  EXPECT_EQ(rooms_of_the_page(rooms), (std::set<std::string>{"app/shell/web", "app/picture", "core"}));
  EXPECT_EQ(rooms_of_the_page({{"app/shell", {}}, {"core", {}}}), (std::set<std::string>{"app/shell"}));
}

}  // namespace
}  // namespace ghostforce::page_test
