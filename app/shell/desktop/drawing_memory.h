// Memory for drawing. OpenGL's libraries crash or hang where a limit of the process (ulimit -v) leaves them too little,
// so it is asked for beforehand.
#pragma once

#include <string_view>

namespace ghostforce {

// Before OpenGL is loaded, for a window of that size [px]. Where there is room for it only without threads of the
// software renderer, it gets none, and draws the same more slowly. Throws Failure(file_trouble) where there is no room,
// whose words end in what else the person can do, the `remedy`.
void make_room_for_drawing(int width, int height, std::string_view remedy);

}  // namespace ghostforce
