// The completion scripts, each run by its shell, which asks the program.
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/cli/command.h"
#include "tests/support/places.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::completion_test {
namespace {

struct Shell {
  const char* name;
  std::vector<std::string> call;  // before the script that drives it
};

void PrintTo(const Shell& shell, std::ostream* out) {
  *out << shell.name;
}

// What is typed, what must be offered then, and what must not.
struct Typed {
  std::string line;
  std::vector<std::string> offered;
  std::vector<std::string> not_offered;
};

const std::vector<Typed> typed_lines{
    {"ghostforce re", {"render", "replay"}, {"run"}},
    {"ghostforce wa", {"wall45"}, {}},
    {"ghostforce my_", {"my_scene.toml"}, {"my_notes.txt"}},
    {"ghostforce --the", {"--theme"}, {}},
    {"ghostforce wall45 --the", {"--theme"}, {"--at"}},
    {"ghostforce --strategy ", {"full", "naive", "anisotropic"}, {"all", "render"}},
    {"ghostforce render wa", {"wall45"}, {"worksheet"}},
    {"ghostforce render my_", {"my_scene.toml"}, {"my_notes.txt"}},
    {"ghostforce render wall45 --strategy ", {"full", "naive", "anisotropic", "all"}, {"my_notes.txt"}},
    {"ghostforce render wall45 --strategy=na", {"naive"}, {"full"}},
    {"ghostforce render wall45 --scale ", {}, {"my_notes.txt", "full"}},
    {"ghostforce render wall45 -o my_", {"my_notes.txt", "my_scene.toml"}, {}},
    {"ghostforce render wall45 --output=my_", {"my_notes.txt", "my_scene.toml"}, {}},
    {"ghostforce render wall45 --set wall.n", {"wall.normal_deg="}, {"wall.point_mm="}},
    {"ghostforce render wall45 --set=wall.n", {"wall.normal_deg="}, {"wall.point_mm="}},
    {"ghostforce sweep wall45 --over wall.n", {"wall.normal_deg="}, {}},
    {"ghostforce replay my_", {"my_notes.txt"}, {}},
    {"ghostforce replay my_run.csv wa", {"wall45"}, {}},
    {"ghostforce replay-session my_", {"my_notes.txt"}, {}},
    {"ghostforce replay-session my_notes.txt --", {"--headless"}, {"--set"}},
    {"ghostforce run --lesson gh", {"ghost"}, {"wall45"}},
    {"ghostforce run --input rep", {"replay:"}, {}},
    {"ghostforce run --input replay:my_n", {"my_notes.txt"}, {}},
    {"ghostforce worksheet ghost wh", {"why"}, {}},
    {"ghostforce doctor --misbehave busy,sil", {"silence"}, {}},
    {"ghostforce doctor --misbehave=busy,sil", {"silence"}, {}},
    {"ghostforce figures --only figure-1 proxy", {"proxy-drift"}, {}},
    {"ghostforce figures -o my_", {"my_folder"}, {"my_notes.txt"}},
    {"ghostforce check my_folder --only ", {"inside"}, {"my_scene", "notes", "my_notes.txt"}},
    {"ghostforce check my_folder --update ins", {"inside"}, {}},
    {"ghostforce check --only ", {}, {"inside", "my_scene", "my_notes.txt"}},
    {"ghostforce help rend", {"render"}, {}},
    {"ghostforce help --format man --f", {}, {"--format"}},
    {"ghostforce check my_folder --only inside --up", {}, {"--update"}},
    {"ghostforce help --format z", {"zsh"}, {"text"}},
};

class Completion : public testing::TestWithParam<Shell> {
 protected:
  Completion() {
    write_whole(folder_ / "script", run_ghostforce({"help", "--format", GetParam().name}).out);
    std::filesystem::create_directory(folder_ / "my_folder");
    for (const char* name : {"my_scene.toml", "my_notes.txt", "my_folder/inside.toml", "my_folder/notes.txt"})
      write_whole(folder_ / name, "");
  }

  // What is offered for each line: of a word with '=' or ':' in it, what follows those.
  std::map<std::string, std::set<std::string>> complete(const std::vector<std::string>& lines) {
    ProgramCall call;
    call.words = {GetParam().call.begin() + 1, GetParam().call.end()};
    call.words.push_back(source_path("/tests/app/cli/complete.") + GetParam().name);
    call.words.push_back(folder_ / "script");
    call.words.insert(call.words.end(), lines.begin(), lines.end());
    call.folder = folder_.path();
    const std::string around = std::filesystem::path(ghostforce_program()).parent_path();
    call.environment.push_back(fmt::format("PATH={}:{}", around, std::getenv("PATH")));
    for (const char* variable : {"HOME=", "XDG_CONFIG_HOME=", "XDG_DATA_HOME=", "XDG_CACHE_HOME="}) {
      call.environment.push_back(variable + folder_.path());
    }
    const Outcome outcome = run_program(GetParam().call.front(), call);
    EXPECT_EQ(outcome.err, "");
    std::map<std::string, std::set<std::string>> offered;
    std::istringstream answer(outcome.out);
    std::string typed;
    for (std::string word; std::getline(answer, word);) {
      if (word.starts_with("> ")) {
        typed = word.substr(2);
        offered[typed];
        continue;
      }
      if (word.empty()) continue;
      while (word.ends_with(' ') || word.ends_with('/')) word.pop_back();
      const std::size_t divider = word.find_last_of("=:,", word.size() - 2);
      offered[typed].insert(divider == std::string::npos ? word : word.substr(divider + 1));
    }
    return offered;
  }

 private:
  TemporaryFolder folder_;
};

TEST_P(Completion, OffersWhatMayFollow) {
  std::vector<std::string> lines;
  for (const Typed& typed : typed_lines) lines.push_back(typed.line);
  const auto offered = complete(lines);
  ASSERT_EQ(offered.size(), lines.size());
  for (const Typed& typed : typed_lines) {
    const std::set<std::string>& words = offered.at(typed.line);
    for (const std::string& word : typed.offered) {
      EXPECT_TRUE(words.contains(word)) << typed.line << ": " << word << testing::PrintToString(words);
    }
    for (const std::string& word : typed.not_offered) {
      EXPECT_FALSE(words.contains(word)) << typed.line << ": " << word;
    }
  }
}

TEST_P(Completion, OffersTheOptionsOfEachCommand) {
  std::vector<std::string> lines;
  for (const Command& command : command_catalog()) lines.push_back("ghostforce " + std::string(command.name) + " --");
  const auto offered = complete(lines);
  for (const Command& command : command_catalog()) {
    const std::string name(command.name);
    std::set<std::string> expected;
    std::istringstream help(run_ghostforce({"help", name}).out);
    for (std::string line; std::getline(help, line);) {
      if (!line.starts_with("  -")) continue;
      line.resize(line.find(' ', 2));
      expected.insert(line.substr(line.find("--")));
    }
    std::set<std::string> words;
    for (std::string word : offered.at("ghostforce " + name + " --")) {
      if (word.ends_with('=')) word.pop_back();
      words.insert(word);
    }
    EXPECT_EQ(words, expected) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(Shells, Completion,
                         testing::Values(Shell{"bash", {"/bin/bash"}}, Shell{"zsh", {"/bin/zsh", "-f"}},
                                         Shell{"fish", {"/usr/bin/fish", "--no-config"}}),
                         [](const auto& shell) { return shell.param.name; });

}  // namespace
}  // namespace ghostforce::completion_test
