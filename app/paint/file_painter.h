// How panes become a file without a window: a picture (FilePainter, UI thread), or their marks as JSON (any thread).
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "app/base/failure.h"
#include "app/files/image.h"
#include "app/picture/marks.h"
#include "app/picture/panes.h"
#include "app/picture/theme.h"

namespace ghostforce {

struct FilePicture {
  const std::vector<Pane>& panes;
  const Theme& theme;
  Vector<2> size;           // of the panes' rectangle [points]
  double text_scale = 1.0;  // turns a nominal text height into points
  std::string_view title;
  double density = 1.0;  // pixels per point, of a PNG
};

// A value that is handed down by who has such a painter: on the desktop it is Cairo's (vector/vector_file_painter.h).
// As it is made, it is the painter of a program that has none: it says so.
struct FilePainter {
  // Of the letters that are painted, for those who place labels.
  MeasureText measure = [](std::string_view, const TextStyle&) -> Vector<2> { throw no_painter(); };
  // Its pixels.
  std::function<Image(const FilePicture& picture)> image = [](const FilePicture&) -> Image { throw no_painter(); };
  // The file's content, of the format that the path ends in: .svg, .pdf, or else PNG. Throws Failure.
  std::function<std::string(const FilePicture& picture, std::string_view path)> paint =
      [](const FilePicture&, std::string_view) -> std::string { throw no_painter(); };

  static Failure no_painter() {
    return {ExitCode::wrong_call, "This program cannot paint such a picture: save the screen as .png, plots as .csv."};
  }
};

// The same picture for a script, with positions in millimetres. An array with one object per mark: role, strategy
// (where it belongs to one), form, and the form's positions, sizes and colours, of a raster without its cells. An arrow
// says where it has no head or is hatched, a label where its letters are bold or none of the three heights of the
// workbench.
nlohmann::ordered_json marks_as_json(const Marks& marks);

}  // namespace ghostforce
