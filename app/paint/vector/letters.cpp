#include "app/paint/vector/letters.h"

#include <cairo-ft.h>
#include <fmt/format.h>
#include <freetype/freetype.h>

#include "app/base/failure.h"
#include "app/base/quoted.h"
#include "app/paint/font_file.h"

namespace ghostforce {
namespace {

constexpr double measured_em = 1000.0;  // large, so that no advance is rounded

void require_read(FT_Error error, const std::string& path) {
  if (error == 0) return;
  throw Failure(ExitCode::file_trouble,
                fmt::format("the font {} cannot be read (FreeType error {}); build again with ./demo, or install the "
                            "program with cmake --install",
                            quoted_text(path, longest_path), error));
}

}  // namespace

struct LabelFont::Handles {
  std::unique_ptr<FT_LibraryRec_, Destroy<FT_Done_FreeType>> library;
  std::unique_ptr<FT_FaceRec_, Destroy<FT_Done_Face>> outlines;
  std::unique_ptr<cairo_font_options_t, Destroy<cairo_font_options_destroy>> options;
  std::unique_ptr<cairo_font_face_t, Destroy<cairo_font_face_destroy>> face;
  std::unique_ptr<cairo_scaled_font_t, Destroy<cairo_scaled_font_destroy>> measured;

  double advance(const std::string& letter) const {
    cairo_text_extents_t extents;
    cairo_scaled_font_text_extents(measured.get(), letter.c_str(), &extents);
    return extents.x_advance;
  }
};

std::string drawable(std::string_view words) {
  return quoted_text(words, words.size());
}

LabelFont::LabelFont(std::string_view file) : handles_(std::make_unique<Handles>()) {
  const std::string path = font_file(file);
  FT_Library library = nullptr;
  require_read(FT_Init_FreeType(&library), path);
  handles_->library.reset(library);
  FT_Face outlines = nullptr;
  require_read(FT_New_Face(library, path.c_str(), 0, &outlines), path);
  handles_->outlines.reset(outlines);
  const double line = static_cast<double>(outlines->ascender) - static_cast<double>(outlines->descender);
  em_ = static_cast<double>(outlines->units_per_EM) / line;
  ascent_ = static_cast<double>(outlines->ascender) / line;

  // Letters fitted to pixels would be as wide as one size of pixel wants them.
  cairo_font_options_t* const options = cairo_font_options_create();
  handles_->options.reset(options);
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  handles_->face.reset(cairo_ft_font_face_create_for_ft_face(outlines, FT_LOAD_NO_HINTING));
  cairo_matrix_t size;
  cairo_matrix_init_scale(&size, measured_em, measured_em);
  cairo_matrix_t upright;
  cairo_matrix_init_identity(&upright);
  handles_->measured.reset(cairo_scaled_font_create(handles_->face.get(), &size, &upright, options));
}

LabelFont::~LabelFont() = default;

double LabelFont::width(std::string_view text, double height) const {
  double width = 0.0;
  for (std::string_view rest = text; !rest.empty();) {
    const auto [code, length] = first_character(rest);
    if (length == 0 || is_control(code) || is_noncharacter(code)) return this->width(drawable(text), height);
    const auto [known, is_new] = advances_.try_emplace(code);
    if (is_new) known->second = handles_->advance(std::string(rest.substr(0, length)));
    width += known->second;
    rest.remove_prefix(length);
  }
  return width / measured_em * em_ * height;
}

void LabelFont::choose_on(cairo_t* target, double height) const {
  cairo_set_font_face(target, handles_->face.get());
  cairo_set_font_options(target, handles_->options.get());
  cairo_set_font_size(target, em_ * height);
}

const LabelFont& label_font(bool is_bold) {
  if (is_bold) {
    static const LabelFont bold(bold_label_font_file);
    return bold;
  }
  static const LabelFont regular(label_font_file);
  return regular;
}

}  // namespace ghostforce
