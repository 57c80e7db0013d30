#include "app/shell/desktop/renderer.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include "app/base/words.h"

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

namespace {

// Those that change what Mesa draws. Some of its beginnings are short enough for strangers' variables: of these the
// whole names.
constexpr std::array<std::string_view, 8> begins{"EGL_", "GALLIUM_", "GALLIVM_",  "LIBGL_",
                                                 "LP_",  "MESA_",    "SOFTPIPE_", "TGSI_"};
constexpr std::array<std::string_view, 5> names_of_mesa{"DRAW_FSE", "DRAW_NO_FSE", "DRAW_USE_LLVM", "NIR_DEBUG",
                                                        "ST_DEBUG"};

// These change no picture: how many threads draw, and where compiled shaders are kept.
constexpr std::array<std::string_view, 2> harmless{"LP_NUM_THREADS", "MESA_SHADER_CACHE_"};

bool is_for_mesa(std::string_view name) {
  const auto begins_name = [name](std::string_view begin) { return name.starts_with(begin); };
  return std::ranges::count(names_of_mesa, name) != 0 ||
         (std::ranges::any_of(begins, begins_name) && std::ranges::none_of(harmless, begins_name));
}

}  // namespace

void choose_offscreen_driver() {
  std::vector<std::string> names;
  for (char** variable = environ; variable != nullptr && *variable != nullptr; ++variable) {
    const std::string_view text = *variable;
    if (const std::string_view name = text.substr(0, text.find('=')); is_for_mesa(name)) names.emplace_back(name);
  }
  if (names.empty()) return;
  for (const std::string& name : names) unsetenv(name.c_str());
  std::ranges::sort(names);
  say("Drawing offscreen with Mesa's own software renderer, so {} {} ignored.\n", fmt::join(names, ", "),
      names.size() == 1 ? "is" : "are");
}

}  // namespace ghostforce
