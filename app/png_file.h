// PNG files: the same image gives the same bytes. Any thread.
#pragma once

#include <string>

#include "app/image.h"

namespace ghostforce {

// The whole file's content.
std::string png_bytes(const Image& image);

// Throws Failure(file_trouble) where the file cannot be read or is no PNG.
Image read_png(const std::string& path);

}  // namespace ghostforce
