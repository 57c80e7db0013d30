#include <emscripten.h>

#include <cstdlib>
#include <filesystem>
#include <memory>
#include <system_error>

#include "app/files/file_exchange.h"

EM_JS_DEPS(file_exchange, "$FS,$UTF8ToString,$stringToNewUTF8")

// clang-format off
EM_JS(void, download_file, (const char* path, const char* name), {
  const address = URL.createObjectURL(new Blob([FS.readFile(UTF8ToString(path))], {type: "application/octet-stream"}));
  const link = document.createElement("a");
  link.href = address;
  link.download = UTF8ToString(name);
  document.body.append(link);
  link.click();
  link.remove();
  // The browser reads it when it likes.
  const long_enough_ms = 60000;
  setTimeout(() => URL.revokeObjectURL(address), long_enough_ms);
})

// What is chosen or dropped comes into the page's own files. The chooser is part of the page.
EM_JS(void, listen_for_files, (), {
  const take = async (files) => {
    for (const file of files) {
      const path = "/opened/" + file.name;
      FS.mkdirTree("/opened");
      try {
        FS.writeFile(path, new Uint8Array(await file.arrayBuffer()));
      } catch (error) {
        // A folder, for instance: whoever opens the path says that nothing is there.
      }
      (Module["chosenFiles"] ||= []).push(path);
    }
  };
  const chooser = document.getElementById("file-chooser");
  chooser.addEventListener("change", async () => {
    await take([...chooser.files]);
    chooser.value = "";  // otherwise the same file could not be chosen again
  });
  addEventListener("dragover", (event) => event.preventDefault());
  addEventListener("drop", (event) => {
    event.preventDefault();
    take([...event.dataTransfer.files]);
  });
})

EM_JS(void, show_file_chooser, (), { document.getElementById("file-chooser").click(); })

// 0: there is none.
EM_JS(char*, take_chosen_file, (), {
  const path = Module["chosenFiles"]?.shift();
  return path === undefined ? 0 : stringToNewUTF8(path);
})
// clang-format on

namespace ghostforce {

void hand_out(const std::string& path) {
  std::error_code ignored;
  // "-" is no file.
  if (!std::filesystem::is_regular_file(path, ignored)) return;
  download_file(path.c_str(), std::filesystem::path(path).filename().c_str());
  std::filesystem::remove(path, ignored);
}

const SavePlace& save_place() noexcept {
  static constexpr SavePlace place{.paints_files = false,
                                   .has_folders = false,
                                   .nothing_typed = "Type a name.",
                                   .new_file = "Your browser saves it.",
                                   .about_recording =
                                       "A new CSV file, which your browser saves when the recording "
                                       "ends. If empty, a name is chosen."};
  return place;
}

void listen_for_files_from_outside() {
  listen_for_files();
}

bool offers_file_chooser() noexcept {
  return true;
}

bool offers_place_chooser() noexcept {
  return false;
}

void choose_file(const FileQuestion&) {
  show_file_chooser();
}

FileAnswer take_chosen_files() {
  FileAnswer answer;
  for (;;) {
    const std::unique_ptr<char, void (*)(void*)> path(take_chosen_file(), std::free);
    if (!path) return answer;
    answer.paths.emplace_back(path.get());
  }
}

bool has_chosen_files() noexcept {
  return false;  // the window looks itself
}

}  // namespace ghostforce
