// Paints panes as vectors, through Cairo: SVG and PDF for papers and slides, sharp at any size. The same marks look as
// the GL painter draws them, so the shapes must match shaders/mark.frag. Needs no window; letters come from the font
// that the program brings, whatever the machine has. One thread at a time.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/picture/panes.h"
#include "app/picture/theme.h"

// Cairo's own names for what it draws on.
using cairo_t = struct _cairo;  // NOLINT(readability-identifier-naming,bugprone-reserved-identifier)

namespace ghostforce {

enum class VectorFormat : std::uint8_t { svg, pdf };

// By the end of the file's name, .svg or .pdf in any case; empty for any other.
std::optional<VectorFormat> vector_format_of(std::string_view path);

// The measure of the letters that are painted here, for those who place labels. Throws Failure(file_trouble) where the
// font cannot be read.
Vector<2> measure_vector_text(std::string_view text, const TextStyle& style);

// The whole file's content; the same call gives the same bytes. `size` is the panes' rectangle [points], `text_scale`
// turns a nominal text height into points. In a PDF letters are text, to be searched and copied; in an SVG they are
// outlines. Throws Failure: file_trouble where the font cannot be read; bug where Cairo gives up.
std::string paint_vector(const std::vector<Pane>& panes, const Theme& theme, const Vector<2>& size, double text_scale,
                         VectorFormat format, std::string_view title);

// The same for a PDF of several pages, each with panes of its own; `pages` is not empty.
std::string paint_pdf(std::span<const std::vector<Pane>> pages, const Theme& theme, const Vector<2>& size,
                      double text_scale, std::string_view title);

// The same on anything that Cairo draws on, one unit of `target` for a point. Throws Failure(file_trouble); whether
// Cairo could draw is for cairo_status() to say.
void paint_panes(const std::vector<Pane>& panes, const Theme& theme, const Vector<2>& size, double text_scale,
                 cairo_t* target);

}  // namespace ghostforce
