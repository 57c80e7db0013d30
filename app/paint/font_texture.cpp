#include "app/paint/font_texture.h"

#include <cstddef>
#include <span>

namespace ghostforce {
namespace {

constexpr std::size_t channels = 4;  // red, green, blue, alpha

void whiten(ImTextureData& texture, const ImTextureRect& part) {
  for (int y = part.y; y < part.y + part.h; ++y) {
    const std::span row(static_cast<unsigned char*>(texture.GetPixelsAt(part.x, y)), channels * part.w);
    for (std::size_t texel = 0; texel < row.size(); texel += channels) {
      if (row[texel + 3] == 0) row[texel] = row[texel + 1] = row[texel + 2] = 0xFF;
    }
  }
}

}  // namespace

void whiten_empty_texels(const ImDrawData& drawing) {
  for (ImTextureData* const texture : *drawing.Textures) {
    if (texture->Format != ImTextureFormat_RGBA32) continue;
    if (texture->Status == ImTextureStatus_WantCreate) {
      whiten(*texture,
             {0, 0, static_cast<unsigned short>(texture->Width), static_cast<unsigned short>(texture->Height)});
    } else if (texture->Status == ImTextureStatus_WantUpdates) {
      for (const ImTextureRect& update : texture->Updates) whiten(*texture, update);
    }
  }
}

}  // namespace ghostforce
