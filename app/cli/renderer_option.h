// --renderer, for commands that draw offscreen.
#pragma once

#include <optional>

#include "app/desktop/renderer.h"

namespace CLI {
class App;
}

namespace ghostforce {

// `renderer` stays empty where the option is not given.
void attach_renderer(CLI::App& command, std::optional<Renderer>& renderer);

}  // namespace ghostforce
