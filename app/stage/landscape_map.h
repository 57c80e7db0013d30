// The parts of the landscape's picture that show numbers as colours; landscape_layers.cpp puts them together.
#pragma once

#include <string>
#include <vector>

#include "app/stage/landscape_contours.h"
#include "app/stage/landscape_layout.h"
#include "app/stage/landscape_words.h"

namespace ghostforce {

// As people read it: "+42 %", "−7 %", "0 %"; "> +999 %" for more than that.
std::string share_words(double share);
// Rounds to 0 %.
bool is_no_share(double share) noexcept;

// A contour as it is drawn, ends of its pieces on the screen.
struct DrawnContour {
  double level;
  std::vector<Vector<2>> corners;
};
// As few pieces as look the same.
std::vector<DrawnContour> drawn_contours(const Landscape& landscape, const LandscapeLayout& layout);

void add_map(const LandscapeView& view, const LandscapeLayout& layout, const Landscape& landscape, Marks& marks);
void add_contours(const LandscapeView& view, const LandscapeLayout& layout, const std::vector<DrawnContour>& contours,
                  Marks& marks);
// Where there is room; the scale of colours tells what is left out.
void add_contour_labels(const LandscapeView& view, const LandscapeLayout& layout,
                        const std::vector<DrawnContour>& contours, LandscapeWords& words);
// With numbers; of what is too little only where the map has any.
void add_colour_scale(const LandscapeView& view, const LandscapeLayout& layout, bool has_too_little,
                      LandscapeWords& words, Marks& marks);

}  // namespace ghostforce
