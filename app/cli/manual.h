// What the program's manual says, as a value: command_tree.h makes it from the tables that --help is made from. Manual
// pages are written from it, and completion is answered. Not for the servo thread.
#pragma once

#include <span>
#include <string>
#include <string_view>
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

// --- Manual pages for man(1), in the macros of man(7). Pure ---

// Of the program: NAME.1.
std::string man_page(const Manual& manual);
// Of one of its commands: PROGRAM-NAME.1.
std::string man_page(const Manual& manual, const ManualCommand& command);

// UTF-8 as text that groff and mandoc show as it is, whatever it contains and whatever the system's encoding.
std::string roff_text(std::string_view text);

// --- Completion: a shell asks the program by `ghostforce __complete WORDS` and prints what it answers; a script in
// assets/completion does so for each shell ---

// What may follow these words, of which the last is being typed. In the first line the kind of paths that may stand
// there, "none", "any", "toml" or "folders", a blank, and what of the last word comes before the path. In each line
// below a whole word, and after a tab, if there is anything to say of it, a sentence. A word that ends in '=' or ':' is
// not finished. Reads the folders whose files are to be chosen from.
std::string completions(const Manual& manual, std::span<const std::string> words);

// A word that names an option: a lone "-" is a standard stream.
bool is_option(std::string_view word) noexcept;

inline constexpr std::string_view completing_command = "__complete";

}  // namespace ghostforce
