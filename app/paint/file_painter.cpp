#include "app/paint/file_painter.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/conventions.h"

namespace ghostforce {
namespace {

using Json = nlohmann::ordered_json;

Json millimetres(const Vector<2>& world) {
  return Json::array({world.x * mm_per_m, world.y * mm_per_m});
}

Json points(const Vector<2>& screen) {
  return Json::array({screen.x, screen.y});
}

std::string hex(Colour colour) {
  return fmt::format("#{:02X}{:02X}{:02X}{:02X}", colour.red, colour.green, colour.blue, colour.alpha);
}

std::string_view shape_name(Shape shape) {
  switch (shape) {
    case Shape::disc:
      return "disc";
    case Shape::diamond:
      return "diamond";
    case Shape::triangle:
      return "triangle";
  }
  return "disc";
}

struct Describe {
  Json& mark;
  void operator()(const HalfPlane& form) const {
    mark["form"] = "half_plane";
    mark["point_mm"] = millimetres(form.point);
    mark["normal"] = Json::array({form.normal.x, form.normal.y});
    mark["fill"] = hex(form.fill);
  }
  void operator()(const Line& form) const {
    mark["form"] = "line";
    mark["from_mm"] = millimetres(form.from);
    mark["to_mm"] = millimetres(form.to);
    mark["width"] = form.width;
    mark["pattern"] = form.pattern;
    mark["colour"] = hex(form.colour);
  }
  void operator()(const Marker& form) const {
    mark["form"] = "marker";
    mark["shape"] = shape_name(form.shape);
    mark["center_mm"] = millimetres(form.center);
    mark["radius"] = form.radius;
    mark["fill"] = hex(form.fill);
    mark["rim"] = hex(form.rim);
  }
  void operator()(const Arrow& form) const {
    mark["form"] = "arrow";
    mark["tail_mm"] = millimetres(form.tail);
    mark["tip_mm"] = millimetres(form.tip);
    mark["offset"] = points(form.offset);
    mark["width"] = form.width;
    mark["fill"] = hex(form.fill);
    mark["rim"] = hex(form.rim);
    if (!form.has_head) mark["head"] = false;
    if (form.is_hatched) mark["hatched"] = true;
  }
  void operator()(const Box& form) const {
    mark["form"] = "box";
    mark["corner_mm"] = millimetres(form.corner);
    mark["offset"] = points(form.offset);
    mark["size"] = points(form.size);
    mark["radius"] = form.radius;
    mark["fill"] = hex(form.fill);
    mark["rim"] = hex(form.rim);
  }
  void operator()(const Area& form) const {
    mark["form"] = "area";
    mark["corners_mm"] = Json::array();
    for (const Vector<2>& corner : form.corners) mark["corners_mm"].push_back(millimetres(corner));
    mark["fill"] = hex(form.fill);
  }
  void operator()(const Raster& form) const {
    mark["form"] = "raster";
    mark["corner_mm"] = millimetres(form.corner);
    mark["size"] = points(form.size);
    mark["columns"] = form.columns;
    mark["rows"] = form.rows;
  }
  void operator()(const Label& form) const {
    mark["form"] = "label";
    mark["text"] = form.text;
    mark["anchor_mm"] = millimetres(form.anchor);
    mark["offset"] = points(form.offset);
    mark["colour"] = hex(form.colour);
    const bool is_of_workbench = form.style == small_text || form.style == normal_text || form.style == large_text;
    if (!is_of_workbench || form.style.is_bold) mark["height"] = form.style.height;
    if (form.style.is_bold) mark["bold"] = true;
  }
};

}  // namespace

Json marks_as_json(const Marks& marks) {
  Json result = Json::array();
  for (const Mark& mark : marks) {
    Json object;
    object["role"] = role_name(mark.role);
    if (mark.strategy) object["strategy"] = strategy(*mark.strategy).name;
    std::visit(Describe{object}, mark.form);
    result.push_back(std::move(object));
  }
  return result;
}

}  // namespace ghostforce
