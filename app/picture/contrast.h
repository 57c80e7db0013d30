// Contrast: how far two colours stand apart for whoever reads one on the other, as WCAG 2 defines it. Pure; any thread.
#pragma once

#include "app/picture/theme.h"

namespace ghostforce {

// What WCAG 2 wants of words (AA). Of large ones it wants 3; here they need as much as the others.
inline constexpr double least_word_contrast = 4.5;

// Of opaque colours: 1, the same, to 21, black and white.
double contrast(Colour one, Colour other) noexcept;

}  // namespace ghostforce
