#include "app/figures/figure_files.h"

#include "app/console/interruption.h"
#include "app/figures/sheet.h"
#include "app/files/png_file.h"
#include "app/paint/image_painter.h"
#include "app/paint/vector/vector_painter.h"

namespace ghostforce {
namespace {

constexpr double density = 2.0;  // of the smaller PNG [pixels per point]

std::string content_of(const Figure& figure, std::string_view ending, const std::string& file_name) {
  const Theme& theme = paper();
  const double text_scale = theme.thickness;
  const auto pixels = [&](double pixels_per_point) {
    return png_bytes(paint_image(figure.panes, theme, figure.size, text_scale, pixels_per_point));
  };
  if (ending == ".png") return pixels(density);
  if (ending == "@2x.png") return pixels(2.0 * density);
  if (const auto format = vector_format_of(file_name)) {
    return paint_vector(figure.panes, theme, figure.size, text_scale, *format, figure.title);
  }
  return csv_text(figure.data);
}

}  // namespace

std::vector<NamedFile> figure_files(std::string_view name, const Figure& figure) {
  std::vector<NamedFile> files;
  for (const std::string_view ending : figure_file_endings) {
    stop_if_interrupted();
    const std::string file_name = std::string(name) + std::string(ending);
    files.push_back({file_name, content_of(figure, ending, file_name)});
  }
  return files;
}

}  // namespace ghostforce
