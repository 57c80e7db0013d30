// The set-up that is on the screen: what Ctrl+C copies and a picture carries in its own file. PNG has texts for that,
// SVG and PDF have a title. Not for the servo thread.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/files/png_writer.h"
#include "app/picture/moment_history.h"
#include "app/state/session.h"
#include "app/state/set_up.h"

namespace ghostforce {

// Of the moment that is shown, which somebody may look back at: with its settings, and its goal as the place of the
// hand, whoever moved it. As a file would hold it, so that its line restores it exactly. UI thread.
SetUp set_up_of(const Session& session, const ShownMoment& shown);

// For a PNG file: the program as "Software", the set-up's line as "Description".
std::vector<PngText> picture_texts(const SetUp& set_up);

// For SVG and PDF: "TITLE: LINE".
std::string picture_title(std::string_view title, const SetUp& set_up);

// What such a file carries: PNG, SVG or PDF, known by its content. Throws ReadError: wrong where it carries no set-up,
// or one that cannot be; unreadable where it cannot be read, or is damaged.
SetUp read_picture_set_up(const std::string& path);

}  // namespace ghostforce
