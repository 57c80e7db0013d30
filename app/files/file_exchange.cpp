#include "app/files/file_exchange.h"

namespace ghostforce {

void hand_out(const std::string&) {}

const SavePlace& save_place() noexcept {
  static constexpr SavePlace place{
      .paints_files = true,
      .has_folders = true,
      .nothing_typed = "Type a path.",
      .new_file = "A new file.",
      .about_recording = "A new CSV file. If empty, a name is chosen in the folder that the program was started in."};
  return place;
}

void listen_for_files_from_outside() {}

bool offers_file_chooser() noexcept {
  return false;
}

void choose_file() {}

std::vector<std::string> take_chosen_files() {
  return {};
}

}  // namespace ghostforce
