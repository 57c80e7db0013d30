// Files between the program and whoever uses it. On the desktop they lie where their paths say. A page has files of its
// own, in memory: the browser downloads them, and its own dialog brings others in. UI thread.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ghostforce {

// A file that is complete, for the person to have. A page's own copy is gone then.
void hand_out(const std::string& path);

// What a dialog that asks for a new file's path says of it.
struct SavePlace {
  bool paints_files;                 // pictures without the screen: vectors, plots, clips
  bool has_folders;                  // else a path is a name
  std::string_view nothing_typed;    // what to do
  std::string_view new_file;         // what becomes of it
  std::string_view about_recording;  // its file
};
const SavePlace& save_place() noexcept;

// Once: from now on take_chosen_files() has what is dropped on a page too. On the desktop the window knows.
void listen_for_files_from_outside();

// What the system's own dialog is to ask a person for.
struct FileQuestion {
  std::optional<std::string> new_file{};  // the path that is proposed for it; empty: for files to open
};
struct FileAnswer {
  FileQuestion question{};
  std::vector<std::string> paths{};  // empty: the person has cancelled
  std::string problem{};             // why there is no answer, as a sentence; empty: there is one
};

// Whether choose_file() opens such a dialog for files to open, and for a new one.
bool offers_file_chooser() noexcept;
bool offers_place_chooser() noexcept;

// Only in answer to a click or a key: browsers allow it at no other time. One dialog at a time.
void choose_file(const FileQuestion& question = {});

// What has been chosen since the last call; what is to be opened is opened as if it had been dropped. On the desktop
// has_chosen_files() says beforehand that there is something.
FileAnswer take_chosen_files();
bool has_chosen_files() noexcept;

// The dialogs of a desktop that has some.
class FileChooser {
 public:
  virtual ~FileChooser() = default;
  virtual bool is_there() const noexcept = 0;
  virtual void ask(const FileQuestion& question) = 0;
  virtual bool has_answer() const noexcept = 0;
  virtual FileAnswer take_answer() = 0;
};
// From now on; null: none. Not on a page.
void use_file_chooser(FileChooser* chooser) noexcept;

}  // namespace ghostforce
