// Files between the program and whoever uses it. On the desktop they lie where their paths say. A page has files of its
// own, in memory: the browser downloads them, and its own dialog brings others in. UI thread.
#pragma once

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

// Whether choose_file() opens the system's own dialog.
bool offers_file_chooser() noexcept;

// Only in answer to a click or a key: browsers allow it at no other time.
void choose_file();

// The paths of those that have been chosen since the last call; to be opened as if they had been dropped.
std::vector<std::string> take_chosen_files();

}  // namespace ghostforce
