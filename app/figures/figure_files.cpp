#include "app/figures/figure_files.h"

#include "app/console/interruption.h"
#include "app/figures/sheet.h"
#include "app/paint/vector/file_painter.h"

namespace ghostforce {
namespace {

constexpr double density = 2.0;  // of the smaller PNG [pixels per point]

std::string content_of(const Figure& figure, std::string_view ending, const std::string& file_name) {
  if (ending == ".csv") return csv_text(figure.data);
  const Theme& theme = paper();
  return paint_file({.panes = figure.panes,
                     .theme = theme,
                     .size = figure.size,
                     .text_scale = theme.thickness,
                     .title = figure.title,
                     .density = ending == "@2x.png" ? 2.0 * density : density},
                    file_name);
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
