// What a command of the program is, and what commands share: the scene, checks of what a person typed, and how a
// command answers. A new command is one file beside this one, one line here, one row in command_catalog.cpp, and a text
// in assets/help.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/base/failure.h"
#include "app/cli/overwrite_guard.h"
#include "app/files/output_file.h"
#include "app/files/read_error.h"
#include "app/files/scene_file.h"
#include "app/files/scene_keys.h"
#include "core/scene.h"
#include "core/tick.h"

namespace CLI {
class Validator;
}

namespace ghostforce {

// Adds options to `command`, those that name files to `files` too, and returns what runs once they are parsed; that
// returns an exit code or throws Failure. Both outlive it.
using AttachCommand = std::function<int()>(CLI::App& command, FileOptions& files);
AttachCommand attach_run;
AttachCommand attach_render;
AttachCommand attach_simulate;
AttachCommand attach_equilibrium;
AttachCommand attach_figures;
AttachCommand attach_worksheet;
AttachCommand attach_sweep;
AttachCommand attach_replay;
AttachCommand attach_replay_session;
AttachCommand attach_measure_user;
AttachCommand attach_check;
AttachCommand attach_doctor;
AttachCommand attach_help;

struct Command {
  std::string_view name;
  std::string_view sentence;  // what it does, for the list of commands
  AttachCommand* attach;
};

// In the order in which --help lists them.
std::span<const Command> command_catalog() noexcept;

// From the words that a person typed, without the program's name, to the command that runs. Returns what they ask for,
// not begun yet: it returns the exit code or throws Failure. Throws Failure(wrong_call) for a call that is wrong.
std::function<int()> parse_command_line(std::vector<std::string> words);

// SCENE and --set, which every command with a scene takes.
struct SceneOptions {
  std::string scene{default_scene_name};
  std::vector<std::string> overrides;

  void attach(CLI::App& command, FileOptions& files, bool scene_required);
  // Whether the person has named one.
  bool is_named() const;
  // Throws Failure, see scene_file.h.
  Scene load() const;

  CLI::Option* option = nullptr;  // of the scene, once attached
};

// --- The values of options ---

// An option's value must be one of these words, which completion offers; if it is not, the nearest is named.
CLI::Validator one_of(std::vector<std::string_view> words);

// An option's value may be one of these words, which completion offers, or anything else.
CLI::Validator suggests(const std::vector<std::string_view>& words);

// An option's value begins with a key of the scene and "=".
CLI::Validator suggests_keys(KeyKind kind);

// The words that completion offers for the option's value: those of all its checks. One that ends in '=' is not
// finished; after one that ends in ':' comes a path.
std::vector<std::string> offered_words(CLI::Option& option);

// What is wrong with a word that a person typed, as a sentence; empty: nothing.
using WordCheck = std::function<std::string(const std::string& word)>;

// An option's value must be a number between these, both ends included; `unit` is for the message. It lets no NaN
// through.
WordCheck number_between(double least, double greatest, std::string unit);
WordCheck whole_number_from(int least);
WordCheck whole_number_between(int least, int greatest);

// An option's value "X,Y" in mm as a position [m]. Throws Failure(wrong_call).
Vector<2> position_from_mm(std::string_view option, std::string_view text);

// The option may be given again and again, with one value each time.
CLI::Option* repeatable(CLI::Option* option);

// Options that make no sense beside another one.
struct Contradiction {
  std::string_view option;  // its name, "SCENE" or "--set"
  std::string_view value;   // its beginning; empty: any
  std::string_view reason;  // goes on after "contradict each other: "
};

// For the option with that name, which is given. Throws Failure(wrong_call) for the first of these that is given too.
void refuse_contradictions(const CLI::App& command, std::string_view given,
                           std::span<const Contradiction> contradictions);

// --- What a command says ---

// Writes this to the standard output. Throws what OutputFile does.
void print(std::string_view text);

// The standard output, a line at a time. Who reads no further (head, less) still gets the exit code. Any one thread.
class Lines {
 public:
  void write(const std::string& line) {
    if (!is_read_) return;
    try {
      output_.write(line + "\n");
      output_.commit();
    } catch (const BrokenPipe&) {
      is_read_ = false;
    }
  }
  bool is_terminal() const noexcept { return output_.is_terminal(); }

 private:
  OutputFile output_{"-"};
  bool is_read_ = true;
};

// Plays the scene's hand from `start`, whose k is 0, to the tick `last`, and writes a row for each tick and each of
// these strategies. `doing` is what the progress on a terminal is called. Ends as end_unstable() does where a loop runs
// away. Throws Failure(interrupted), and what OutputFile throws.
void write_played(OutputFile& file, std::string_view doing, const Scene& scene, const TickState<2>& start,
                  std::int64_t last, std::span<const StrategyId> ids);

// A note on stderr where the scripted hand never arrives, or hardly moves: the numbers are probably in another unit.
void tell_of_doubtful_times(const Scene& scene);
void tell_of_doubtful_path(const Scene& scene);

// Ends a command whose loop has run away, with unstable_loop() (run.h): a pipe has the whole rows until then, and a file
// does not come to be.
[[noreturn]] void end_unstable(OutputFile& file, StrategyId strategy, double time_s, std::string_view run = {});

// The exit code of an error that knows of none: of a file that was to be read. Pure, any thread.
constexpr ExitCode exit_code_of(ReadError::Kind kind) noexcept {
  return kind == ReadError::Kind::wrong ? ExitCode::wrong_call : ExitCode::file_trouble;
}

}  // namespace ghostforce
