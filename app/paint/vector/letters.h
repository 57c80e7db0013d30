// The letters of labels in vector pictures: the fonts that the program brings, whatever the machine has. One thread at
// a time.
#pragma once

#include <cairo.h>

#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>

namespace ghostforce {

// Owner of what Cairo or FreeType made, by the function that ends it.
template <auto destroy>
struct Destroy {
  void operator()(auto* object) const { destroy(object); }
};

// Words may come from a file's name, and Cairo takes nothing but UTF-8 without any of what Unicode calls no character.
std::string drawable(std::string_view words);

// Sizes follow the screen's convention: a height is that of a line of text, from the highest to the lowest letter.
class LabelFont {
 public:
  // Of a font file by its name. Throws Failure(file_trouble) where it cannot be read.
  explicit LabelFont(std::string_view file);
  ~LabelFont();
  LabelFont(const LabelFont&) = delete;
  LabelFont& operator=(const LabelFont&) = delete;

  double width(std::string_view text, double height) const;
  // Of the baseline below the upper edge of the line.
  double ascent(double height) const { return ascent_ * height; }
  void choose_on(cairo_t* target, double height) const;

 private:
  struct Handles;
  std::unique_ptr<Handles> handles_;
  mutable std::unordered_map<char32_t, double> advances_;  // Cairo takes long to look one up
  double em_ = 1.0;                                        // of the height
  double ascent_ = 1.0;
};

// Kept until the program ends: Cairo's own caches may hold a font longer than any picture.
const LabelFont& label_font(bool is_bold);

}  // namespace ghostforce
