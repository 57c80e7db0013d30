// Which renderers this machine has. Each is tried in a process of its own, so that a driver that crashes or hangs does no
// harm, and nothing of it stays. Takes some 50 ms each. Throws nothing but Failure(interrupted). Call it
// while there is one thread.
#pragma once

#include <string>
#include <vector>

#include "app/shell/desktop/renderer.h"

namespace ghostforce {

struct RendererFinding {
  Renderer renderer;
  bool is_there = false;
  bool is_default = false;  // draws where nobody asks for one
  std::string words;        // what draws and its version, or why it cannot and what to install
};

// In the order of the catalog.
std::vector<RendererFinding> examine_renderers();

// One line about the renderer that draws where nobody asks for one, "llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 4.5 (Core
// Profile) Mesa 22.3.6, by egl", or why there is none.
std::string default_renderer_words();

}  // namespace ghostforce
