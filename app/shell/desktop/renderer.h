// What draws offscreen: the catalog of renderers. Immutable, any thread.
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

}  // namespace ghostforce
