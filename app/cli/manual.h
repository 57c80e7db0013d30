// What the program's manual says, as a value: command_tree.h makes it from the tables that --help is made from.
// Manual pages (man_page.h) are written from it, and completion (completion.h) is answered.
#pragma once

#include <string>
#include <vector>

namespace ghostforce {

// Which paths an option's value may be. Of toml_names it is the name, without extension, of a .toml file in a folder
// that the arguments name.
enum class ManualPaths { none, any, toml, folders, toml_names };

// An option, or an argument, which has no dashes.
struct ManualOption {
  std::vector<std::string> names{};  // "-o", "--output"; of an argument its only one, "SCENE"
  std::string value{};               // what stands for its value in the manual; empty: it has none
  std::string sentence{};
  bool is_required = false;
  bool may_repeat = false;              // given again and again
  bool takes_many = false;              // takes several values, one after another
  bool is_list = false;                 // takes several values in one word, with commas between
  std::vector<std::string> excluded{};  // the names of options that may not be given too
  std::vector<std::string> needed{};    // and of those that must be
  ManualPaths paths = ManualPaths::none;
  // What completion offers. A word that ends in '=' is not finished; after one that ends in ':' comes a path.
  std::vector<std::string> words{};

  bool has_value() const noexcept { return !value.empty(); }
};

// A command, or the program itself. In its notes, lines that begin with two blanks stay as they are; a paragraph may be
// filled. In its examples, all lines stay.
struct ManualCommand {
  std::string name{};
  std::string sentence{};
  std::string notes{};
  std::string examples{};
  std::vector<ManualOption> arguments{};
  std::vector<ManualOption> options{};
};

struct ManualRow {
  std::string name{};
  std::string meaning{};
};

struct Manual {
  std::string version{};
  ManualCommand program{};
  std::vector<ManualCommand> commands{};
  std::string default_command{};  // what is meant where none is named
  std::vector<ManualRow> exit_codes{};
  std::vector<ManualRow> environment{};
  std::vector<ManualRow> files{};
};

}  // namespace ghostforce
