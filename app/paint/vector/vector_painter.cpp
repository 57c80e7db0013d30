#include "app/paint/vector/vector_painter.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <new>
#include <numbers>

#include "app/base/failure.h"
#include "app/files/xml_text.h"
#include "app/paint/vector/letters.h"
#include "app/paint/vector/raster_painter.h"
#include "app/picture/marks.h"
#include "ghostforce_version.h"

namespace ghostforce {
namespace {

using Context = std::unique_ptr<cairo_t, Destroy<cairo_destroy>>;
using PathHolder = std::unique_ptr<cairo_path_t, Destroy<cairo_path_destroy>>;
using Surface = std::unique_ptr<cairo_surface_t, Destroy<cairo_surface_destroy>>;

// ---- Marks ----------------------------------------------------------------------------------------------------------

// Must match shaders/mark.frag and gl_painter.cpp.
constexpr double arrow_head = 2.3;
constexpr double head_slenderness = 1.9;
constexpr double longest_head = 0.8;
constexpr double diamond_reach = 1.3;
constexpr double triangle_half_side = 1.25;
constexpr double triangle_rise = 0.12;
constexpr double stripe_share = 0.4;  // of stripe_step

constexpr double turn = 2.0 * std::numbers::pi;

double share(std::uint8_t channel) {
  return static_cast<double>(channel) / 255.0;
}

class MarkPainter {
 public:
  MarkPainter(cairo_t* target, const Camera& camera, double text_scale)
      : target_(target), camera_(camera), text_scale_(text_scale) {}

  void paint(const Marks& marks) const {
    for (std::size_t i = 0; i < marks.size();) {
      if (std::holds_alternative<Line>(marks[i].form)) {
        i = paint_curve(marks, i);
      } else {
        std::visit([this](const auto& form) { paint_form(form); }, marks[i].form);
        ++i;
      }
    }
    // Words stand above everything, as on the screen.
    for (const Mark& mark : marks) {
      if (const auto* label = std::get_if<Label>(&mark.form)) paint_label(*label);
    }
  }

 private:
  Vector<2> on_screen(const Vector<2>& world, const Vector<2>& offset = Vector<2>(0.0)) const {
    return to_screen(camera_, world) + offset;
  }

  void choose(Colour colour) const {
    cairo_set_source_rgba(target_, share(colour.red), share(colour.green), share(colour.blue), share(colour.alpha));
  }

  void outline(std::span<const Vector<2>> corners) const {
    for (const Vector<2>& corner : corners) cairo_line_to(target_, corner.x, corner.y);
    cairo_close_path(target_);
  }

  // Half of the rim lies on the fill, so a translucent rim would show it; themes have none.
  void fill_and_rim(Colour fill, Colour rim, double rim_width, cairo_line_join_t join) const {
    fill_outline(fill);
    add_rim(rim, rim_width, join);
  }

  void fill_outline(Colour fill) const {
    if (fill.alpha == 0) return;
    choose(fill);
    cairo_fill_preserve(target_);
  }

  void add_rim(Colour rim, double rim_width, cairo_line_join_t join) const {
    if (rim_width > 0.0) {
      choose(rim);
      cairo_set_line_join(target_, join);
      cairo_set_line_width(target_, rim_width);
      cairo_stroke_preserve(target_);
    }
    cairo_new_path(target_);
  }

  void paint_form(const Line&) const {}   // see paint_curve()
  void paint_form(const Label&) const {}  // see paint()

  // What of the pane's rectangle lies behind the edge.
  void paint_form(const HalfPlane& form) const {
    const Vector<2> point = on_screen(form.point);
    const Vector<2> normal = to_screen_direction(form.normal);
    const Vector<2>& size = camera_.size;
    const std::array<Vector<2>, 4> pane{{{0.0, 0.0}, {size.x, 0.0}, {size.x, size.y}, {0.0, size.y}}};
    std::vector<Vector<2>> behind;
    for (std::size_t i = 0; i < pane.size(); ++i) {
      const Vector<2>& corner = pane[i];
      const Vector<2>& next = pane[(i + 1) % pane.size()];
      const double height = glm::dot(corner - point, normal);
      const double next_height = glm::dot(next - point, normal);
      if (height <= 0.0) behind.push_back(corner);
      if ((height < 0.0) != (next_height < 0.0) && height != next_height) {
        behind.push_back(corner + (next - corner) * (height / (height - next_height)));
      }
    }
    if (behind.empty()) return;
    outline(behind);
    choose(form.fill);
    cairo_fill(target_);
  }

  void paint_form(const Marker& form) const {
    const Vector<2> at = on_screen(form.center, form.offset);
    const double radius = form.radius;
    switch (form.shape) {
      case Shape::disc:
        cairo_arc(target_, at.x, at.y, radius, 0.0, turn);
        cairo_close_path(target_);
        fill_and_rim(form.fill, form.rim, form.rim_width, CAIRO_LINE_JOIN_ROUND);
        return;
      case Shape::diamond: {
        const double reach = diamond_reach * radius;
        outline(std::array<Vector<2>, 4>{{at + Vector<2>(reach, 0.0), at + Vector<2>(0.0, reach),
                                          at - Vector<2>(reach, 0.0), at - Vector<2>(0.0, reach)}});
        fill_and_rim(form.fill, form.rim, form.rim_width, CAIRO_LINE_JOIN_MITER);
        return;
      }
      case Shape::triangle: {
        const double half_side = triangle_half_side * radius;
        const double in_radius = half_side / std::numbers::sqrt3;
        const Vector<2> middle = at - Vector<2>(0.0, triangle_rise * radius);
        outline(std::array<Vector<2>, 3>{{middle - Vector<2>(0.0, 2.0 * in_radius),
                                          middle + Vector<2>(half_side, in_radius),
                                          middle + Vector<2>(-half_side, in_radius)}});
        fill_and_rim(form.fill, form.rim, form.rim_width, CAIRO_LINE_JOIN_ROUND);
        return;
      }
    }
  }

  void paint_form(const Arrow& form) const {
    const Vector<2> tail = on_screen(form.tail, form.offset);
    const Vector<2> reach = on_screen(form.tip, form.offset) - tail;
    const double length = glm::length(reach);
    const Vector<2> along = length > 0.0 ? reach / length : Vector<2>(1.0, 0.0);
    const Vector<2> across{-along.y, along.x};
    const double half_width = 0.5 * form.width;
    const double half_head = form.has_head ? arrow_head * half_width : half_width;
    const auto corner = [&](double x, double y) { return tail + along * x + across * y; };
    if (form.has_head) {
      const double neck = length - std::min(head_slenderness * half_head, longest_head * length);
      outline(std::array<Vector<2>, 7>{{corner(0.0, -half_width), corner(neck, -half_width), corner(neck, -half_head),
                                        corner(length, 0.0), corner(neck, half_head), corner(neck, half_width),
                                        corner(0.0, half_width)}});
    } else {
      outline(std::array<Vector<2>, 4>{{corner(0.0, -half_width), corner(length, -half_width),
                                        corner(length, half_width), corner(0.0, half_width)}});
    }
    fill_outline(form.fill);
    if (form.is_hatched && form.width > 0.0) {
      const PathHolder shape(cairo_copy_path(target_));
      cairo_save(target_);
      cairo_clip(target_);
      const double step = stripe_step * form.width;
      choose(form.rim);
      cairo_set_line_width(target_, stripe_share * step);
      // By where their middles cross the axis.
      const double apart = step * std::numbers::sqrt2;
      const double first = 0.5 * apart - std::ceil(half_head / apart) * apart;
      cairo_new_path(target_);
      for (double at = first; at < length + half_head + apart; at += apart) {
        const Vector<2> upper = corner(at + 2.0 * half_head, -2.0 * half_head);
        const Vector<2> lower = corner(at - 2.0 * half_head, 2.0 * half_head);
        cairo_move_to(target_, upper.x, upper.y);
        cairo_line_to(target_, lower.x, lower.y);
      }
      cairo_stroke(target_);
      cairo_restore(target_);
      cairo_append_path(target_, shape.get());
    }
    add_rim(form.rim, form.rim_width, CAIRO_LINE_JOIN_ROUND);
  }

  void paint_form(const Box& form) const {
    const Vector<2> corner = on_screen(form.corner, form.offset);
    const double radius = std::min({form.radius, 0.5 * form.size.x, 0.5 * form.size.y});
    if (radius > 0.0) {
      const Vector<2> least = corner + Vector<2>(radius);
      const Vector<2> most = corner + form.size - Vector<2>(radius);
      cairo_arc(target_, least.x, least.y, radius, 0.5 * turn, 0.75 * turn);
      cairo_arc(target_, most.x, least.y, radius, 0.75 * turn, turn);
      cairo_arc(target_, most.x, most.y, radius, 0.0, 0.25 * turn);
      cairo_arc(target_, least.x, most.y, radius, 0.25 * turn, 0.5 * turn);
      cairo_close_path(target_);
    } else {
      cairo_rectangle(target_, corner.x, corner.y, form.size.x, form.size.y);
    }
    fill_and_rim(form.fill, form.rim, form.rim_width, CAIRO_LINE_JOIN_ROUND);
  }

  void paint_form(const Area& form) const {
    if (form.corners.empty()) return;
    for (const Vector<2>& corner : form.corners) {
      const Vector<2> at = on_screen(corner);
      cairo_line_to(target_, at.x, at.y);
    }
    cairo_close_path(target_);
    choose(form.fill);
    cairo_set_fill_rule(target_, CAIRO_FILL_RULE_EVEN_ODD);
    cairo_fill(target_);
    cairo_set_fill_rule(target_, CAIRO_FILL_RULE_WINDING);
  }

  void paint_form(const Raster& form) const { paint_raster(form, on_screen(form.corner), target_); }

  // A trail is hundreds of short lines, each beginning where the last one ended. As one stroke it looks the same and
  // can be changed as one in a drawing program. Translucent lines stay apart: on the screen they darken where they
  // meet. Returns the number of the first mark behind the curve.
  std::size_t paint_curve(const Marks& marks, std::size_t first) const {
    const Line& start = std::get<Line>(marks[first].form);
    const Line* last = &start;
    const Vector<2> from = on_screen(start.from);
    cairo_move_to(target_, from.x, from.y);
    double end = start.pattern_start;  // [m] along the curve
    std::size_t next = first;
    while (true) {
      const Vector<2> to = on_screen(last->to);
      cairo_line_to(target_, to.x, to.y);
      end += glm::distance(last->from, last->to);
      ++next;
      const Line* following = next < marks.size() ? std::get_if<Line>(&marks[next].form) : nullptr;
      if (following == nullptr || !continues(*last, *following, end)) break;
      last = following;
    }
    choose(start.colour);
    cairo_set_line_width(target_, start.width);
    cairo_set_line_join(target_, CAIRO_LINE_JOIN_ROUND);
    if (is_dashed(start)) {
      cairo_set_dash(target_, start.pattern.data(), static_cast<int>(start.pattern.size()),
                     points(start.pattern_start));
      cairo_stroke(target_);
      cairo_set_dash(target_, nullptr, 0, 0.0);
      // Dashes are cut square; where the line itself begins or ends within one, it is round.
      if (is_in_dash(start, start.pattern_start)) paint_round_end(start, start.to, start.from);
      if (is_in_dash(start, end)) paint_round_end(start, last->from, last->to);
    } else {
      cairo_set_line_cap(target_, CAIRO_LINE_CAP_ROUND);
      cairo_stroke(target_);
      cairo_set_line_cap(target_, CAIRO_LINE_CAP_BUTT);
    }
    return next;
  }

  double points(double metres) const { return metres * camera_.points_per_metre; }

  static bool is_dashed(const Line& line) { return line.pattern[0] > 0.0; }

  bool continues(const Line& line, const Line& following, double end) const {
    constexpr double visible = 0.05;  // that far apart dashes would be seen to jump [points]
    return following.from == line.to && following.width == line.width && following.colour == line.colour &&
           line.colour.alpha == 255 && following.pattern == line.pattern &&
           (!is_dashed(line) || points(std::abs(following.pattern_start - end)) < visible);
  }

  bool is_in_dash(const Line& line, double along) const {
    const auto& [drawn, left_out, drawn_again, left_out_again] = line.pattern;
    const double x = std::fmod(points(along), drawn + left_out + drawn_again + left_out_again);
    const double second = drawn + left_out;
    return (x > 0.0 && x < drawn) || (x > second && x < second + drawn_again);
  }

  void paint_round_end(const Line& style, const Vector<2>& before, const Vector<2>& end) const {
    const Vector<2> at = on_screen(end);
    const Vector<2> ahead = at - on_screen(before);
    const double angle = std::atan2(ahead.y, ahead.x);
    cairo_arc(target_, at.x, at.y, 0.5 * style.width, angle - 0.25 * turn, angle + 0.25 * turn);
    cairo_fill(target_);
  }

  void paint_label(const Label& label) const {
    const double height = label.style.height * text_scale_;
    const LabelFont& font = label_font(label.style.is_bold);
    const Vector<2> at = on_screen(label.anchor, label.offset) + Vector<2>(0.0, font.ascent(height));
    const std::string words = drawable(label.text);
    font.choose_on(target_, height);
    if (label.halo.alpha > 0) {
      // An outline round the letters, not more letters: a search in a PDF should find each word once.
      cairo_move_to(target_, at.x, at.y);
      cairo_text_path(target_, words.c_str());
      choose(label.halo);
      cairo_set_line_join(target_, CAIRO_LINE_JOIN_ROUND);
      cairo_set_line_width(target_, 2.0 * halo_reach * height);
      cairo_stroke(target_);
    }
    choose(label.colour);
    cairo_move_to(target_, at.x, at.y);
    cairo_show_text(target_, words.c_str());
  }

  static constexpr double halo_reach = 0.1;  // of the text's height, as in label_painter.cpp

  cairo_t* target_;
  const Camera& camera_;
  double text_scale_;
};

void fill_rectangle(cairo_t* target, const Vector<2>& corner, const Vector<2>& size, Colour colour) {
  cairo_set_source_rgb(target, share(colour.red), share(colour.green), share(colour.blue));
  cairo_rectangle(target, corner.x, corner.y, size.x, size.y);
  cairo_fill(target);
}

// ---- Files ----------------------------------------------------------------------------------------------------------

// Called by Cairo, through which no exception may fly.
cairo_status_t append(void* file, const unsigned char* bytes, unsigned int count) noexcept {
  try {
    static_cast<std::string*>(file)->append(reinterpret_cast<const char*>(bytes), count);
    return CAIRO_STATUS_SUCCESS;
  } catch (const std::bad_alloc&) {
    return CAIRO_STATUS_NO_MEMORY;
  }
}

Surface surface_for(VectorFormat format, const Vector<2>& size, std::string_view title, std::string& file) {
  if (format == VectorFormat::svg) {
    Surface surface(cairo_svg_surface_create_for_stream(append, &file, size.x, size.y));
    cairo_svg_surface_set_document_unit(surface.get(), CAIRO_SVG_UNIT_PT);
    return surface;
  }
  Surface surface(cairo_pdf_surface_create_for_stream(append, &file, size.x, size.y));
  // Later versions let Cairo pack the title away, where who looks for it (app/files/picture_title.h) would not find it.
  cairo_pdf_surface_restrict_to_version(surface.get(), CAIRO_PDF_VERSION_1_4);
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE, drawable(title).c_str());
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATOR,
                                 fmt::format("ghostforce {}", version).c_str());
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "");  // else the time of day
  return surface;
}

// Cairo numbers surfaces and images as long as the program runs, which would make each file another.
void number_anew(std::string& file) {
  constexpr std::string_view surface = "id=\"surface";
  if (const std::size_t at = file.find(surface); at != std::string::npos) {
    const std::size_t number = at + surface.size();
    file.erase(number, file.find('"', number) - number);
  }
  constexpr std::string_view image = "<image id=\"";
  int count = 0;
  for (std::size_t at = file.find(image); at != std::string::npos; at = file.find(image, at)) {
    at += image.size();
    const std::string old = file.substr(at, file.find('"', at) - at) + '"';
    const std::string name = fmt::format("picture{}\"", ++count);
    file.replace(at, old.size(), name);
    for (std::size_t use = file.find('#' + old); use != std::string::npos; use = file.find('#' + old, use)) {
      file.replace(use + 1, old.size(), name);
    }
  }
}

// Nor does it give a title.
void tidy_svg(std::string& file, std::string_view title) {
  number_anew(file);
  const std::size_t root = file.find('>', file.find("<svg"));
  const std::string words = xml_text(drawable(title));
  if (root != std::string::npos) file.insert(root + 1, "\n<title>" + words + "</title>");
}

void require_cairo(cairo_status_t status) {
  if (status == CAIRO_STATUS_SUCCESS) return;
  throw Failure(ExitCode::bug, fmt::format("Cairo cannot make this picture ({}); a PNG needs no Cairo, and a smaller "
                                           "size less memory",
                                           cairo_status_to_string(status)));
}

std::string paint_pages(std::span<const std::vector<Pane>> pages, const Theme& theme, const Vector<2>& size,
                        double text_scale, VectorFormat format, std::string_view title) {
  std::string file;
  const Surface surface = surface_for(format, size, title, file);
  {
    const Context target(cairo_create(surface.get()));
    for (std::size_t i = 0; i < pages.size(); ++i) {
      if (i > 0) cairo_show_page(target.get());
      paint_panes(pages[i], theme, size, text_scale, target.get());
    }
    require_cairo(cairo_status(target.get()));
  }
  cairo_surface_finish(surface.get());
  require_cairo(cairo_surface_status(surface.get()));
  if (format == VectorFormat::svg) tidy_svg(file, title);
  return file;
}

}  // namespace

std::optional<VectorFormat> vector_format_of(std::string_view path) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  if (ending == ".svg") return VectorFormat::svg;
  if (ending == ".pdf") return VectorFormat::pdf;
  return std::nullopt;
}

Vector<2> measure_vector_text(std::string_view text, const TextStyle& style) {
  return {label_font(style.is_bold).width(text, style.height), style.height};
}

void paint_panes(const std::vector<Pane>& panes, const Theme& theme, const Vector<2>& size, double text_scale,
                 cairo_t* target) {
  const bool has_gaps = panes.size() > 1;
  fill_rectangle(target, Vector<2>(0.0), size, has_gaps ? theme.panel_border : theme.background);
  for (const Pane& pane : panes) {
    if (has_gaps) fill_rectangle(target, pane.corner, pane.camera.size, theme.background);
    cairo_save(target);
    cairo_rectangle(target, pane.corner.x, pane.corner.y, pane.camera.size.x, pane.camera.size.y);
    cairo_clip(target);
    cairo_translate(target, pane.corner.x, pane.corner.y);
    MarkPainter(target, pane.camera, text_scale).paint(pane.marks);
    cairo_restore(target);
  }
}

std::string paint_vector(const std::vector<Pane>& panes, const Theme& theme, const Vector<2>& size, double text_scale,
                         VectorFormat format, std::string_view title) {
  return paint_pages(std::span(&panes, 1), theme, size, text_scale, format, title);
}

std::string paint_pdf(std::span<const std::vector<Pane>> pages, const Theme& theme, const Vector<2>& size,
                      double text_scale, std::string_view title) {
  return paint_pages(pages, theme, size, text_scale, VectorFormat::pdf, title);
}

}  // namespace ghostforce
