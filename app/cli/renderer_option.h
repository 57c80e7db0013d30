// --renderer, for commands that draw offscreen.
#pragma once

#include <optional>

#include "app/desktop/renderer.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace ghostforce {

// `renderer` stays empty where the option is not given.
CLI::Option* attach_renderer(CLI::App& command, std::optional<Renderer>& renderer);

}  // namespace ghostforce
