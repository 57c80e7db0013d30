#include "app/shell/desktop/renderer.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace ghostforce {
namespace {

constexpr std::array renderers{
    RendererEntry{Renderer::egl, "egl", "Mesa's software renderer, by EGL",
                  "install Debian's packages libegl1 and libgl1-mesa-dri", true},
    RendererEntry{Renderer::osmesa, "osmesa", "Mesa's software renderer, by OSMesa",
                  "install Debian's package libosmesa6", true},
    RendererEntry{
        Renderer::gpu, "gpu", "the graphics card, by EGL: fast, but its pixels differ from machine to machine",
        "install the graphics card's driver and Debian's package libegl1, or leave out --renderer gpu", false},
};

}  // namespace

std::span<const RendererEntry> renderer_catalog() noexcept {
  return renderers;
}

const RendererEntry& entry_of(Renderer renderer) noexcept {
  return renderers[static_cast<std::size_t>(renderer)];
}

std::optional<Renderer> find_renderer(std::string_view name) noexcept {
  const auto found = std::ranges::find(renderers, name, &RendererEntry::name);
  return found == renderers.end() ? std::nullopt : std::optional(found->renderer);
}

}  // namespace ghostforce
