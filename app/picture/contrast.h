// Contrast: how far two colours stand apart for whoever reads one on the other, as WCAG 2 defines it. Pure; any thread.
#pragma once

#include "app/picture/theme.h"

namespace ghostforce {

// What WCAG 2 wants for words (AA): 4.5, and 3 for large ones.
inline constexpr double least_word_contrast = 4.5;
inline constexpr double least_large_word_contrast = 3.0;

// Of opaque colours: 1, the same, to 21, black and white.
double contrast(Colour one, Colour other) noexcept;

}  // namespace ghostforce
