// What draws offscreen: the catalog of renderers, which is immutable, any thread; and the driver that is chosen for them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace ghostforce {

enum class Renderer : std::uint8_t { egl, osmesa, gpu };

struct RendererEntry {
  Renderer renderer;
  std::string_view name;      // on the command line
  std::string_view sentence;  // what it is, for the help
  std::string_view source;    // what to install where it is missing
  bool is_tried_unasked;      // a graphics card is not: its pictures are not another machine's
};

// In the order in which they are tried.
std::span<const RendererEntry> renderer_catalog() noexcept;
const RendererEntry& entry_of(Renderer renderer) noexcept;
// Empty when none has that name.
std::optional<Renderer> find_renderer(std::string_view name) noexcept;

// From now on the software renderer that Mesa chooses by itself draws offscreen, whatever the environment says. What
// somebody has set there for the programs on their desktop (another driver, another version of OpenGL) makes Mesa draw
// other pictures, or crash where there is no desktop. Takes such variables out of the environment, and says so on the
// standard error. Before any OpenGL is loaded and any thread is started.
void choose_offscreen_driver();

}  // namespace ghostforce
