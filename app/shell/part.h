// How much of the screen a picture shows.
#pragma once

#include <cstdint>

#include "app/picture/theme.h"
#include "app/state/face.h"

namespace ghostforce {

enum class Part : std::uint8_t {
  window,  // scene, panels and bars
  scene,   // the scene alone
};

// What painters multiply the height of a face's labels by: those of the stage are as large as they say.
inline double text_scale_of(Face face, double scale, const Theme& theme) noexcept {
  return face == Face::stage ? 1.0 : scale * theme.thickness;
}

}  // namespace ghostforce
