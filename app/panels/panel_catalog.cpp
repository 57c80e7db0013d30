#include "app/panels/panel_catalog.h"

#include <array>

namespace ghostforce {
namespace {

constexpr std::array panels{
    Panel{"Live", draw_live_values},    Panel{"Rendering", draw_rendering},
    Panel{"User", draw_user},           Panel{"Wall and device", draw_wall_and_device},
    Panel{"Mouse and keys", draw_keys},
};

}  // namespace

std::span<const Panel> panel_catalog() noexcept {
  return panels;
}

}  // namespace ghostforce
