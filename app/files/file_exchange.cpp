#include "app/files/file_exchange.h"

namespace ghostforce {

void hand_out(const std::string&) {}

const SavePlace& save_place() noexcept {
  static constexpr SavePlace place{
      .paints_files = true,
      .has_folders = true,
      .nothing_typed = "Type a path.",
      .new_file = "A new file.",
      .about_recording =
          "A new CSV file, and its receipt beside it. If empty, a name is chosen in the folder that the program was "
          "started in."};
  return place;
}

void listen_for_files_from_outside() {}

namespace {

FileChooser* file_chooser = nullptr;

}  // namespace

void use_file_chooser(FileChooser* chooser) noexcept {
  file_chooser = chooser;
}

bool offers_file_chooser() noexcept {
  return file_chooser != nullptr && file_chooser->is_there();
}

bool offers_place_chooser() noexcept {
  return offers_file_chooser();
}

void choose_file(const FileQuestion& question) {
  if (file_chooser != nullptr) file_chooser->ask(question);
}

FileAnswer take_chosen_files() {
  return has_chosen_files() ? file_chooser->take_answer() : FileAnswer{};
}

bool has_chosen_files() noexcept {
  return file_chooser != nullptr && file_chooser->has_answer();
}

}  // namespace ghostforce
