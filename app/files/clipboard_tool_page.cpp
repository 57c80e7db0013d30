#include <emscripten.h>

#include "app/files/clipboard_tool.h"

// The browser tells later whether it has taken the picture, and perhaps asks the person first.
// clang-format off
EM_JS(int, begin_copy_of_png, (const char* bytes, int size), {
  const copies = (Module["pictureCopies"] ||= []);
  const number = copies.push("under way") - 1;
  const refuse = () => { copies[number] = "refused"; };
  try {
    const picture = new Blob([HEAPU8.slice(bytes, bytes + size)], {type: "image/png"});
    navigator.clipboard.write([new ClipboardItem({"image/png": picture})])
        .then(() => { copies[number] = "done"; }, refuse);
  } catch (error) {
    refuse();
  }
  return number;
})

// 0: it is under way; 1: done; 2: refused.
EM_JS(int, state_of_copy, (int number), {
  return ["under way", "done", "refused"].indexOf(Module["pictureCopies"][number]);
})
// clang-format on

namespace ghostforce {

std::string ClipboardTool::copy_png(std::string_view png, DisplayKind) {
  children_.push_back(begin_copy_of_png(png.data(), static_cast<int>(png.size())));
  return {};
}

std::string ClipboardTool::poll() {
  std::string problem;
  std::erase_if(children_, [&problem](pid_t copy) {
    const int state = state_of_copy(copy);
    if (state == 2) problem = "Your browser does not let this page copy pictures. Save the picture instead.";
    return state != 0;
  });
  return problem;
}

}  // namespace ghostforce
