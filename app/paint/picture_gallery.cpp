#include "app/paint/picture_gallery.h"

namespace ghostforce {

unsigned int PictureGallery::picture(std::size_t number, std::size_t count, const Theme& theme, int width, int height,
                                     const std::function<Pane(std::size_t)>& pane_of) {
  if (theme_ != &theme || width_ != width || height_ != height) {
    theme_ = &theme;
    width_ = width;
    height_ = height;
    pictures_.clear();
    for (std::size_t i = 0; i < count; ++i) pictures_.push_back(painter_.texture_of(pane_of(i), theme));
  }
  return pictures_[number].name();
}

}  // namespace ghostforce
