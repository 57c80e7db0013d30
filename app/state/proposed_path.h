// The path that a saving dialog proposes. UI thread.
#pragma once

#include <string>
#include <string_view>

#include "app/state/session.h"

namespace ghostforce {

// A name for a file from a scene's title: letters, digits and hyphens.
std::string file_stem(std::string_view title);

// The first that is free of STEM.EXTENSION, STEM-2.EXTENSION … in the folder that the program was started in, absolute;
// where there are no folders (file_exchange.h), the name.
std::string proposed_path(std::string_view stem, std::string_view extension);

// Of what this dialog saves. Empty: it saves nothing.
std::string proposed_path(const Session& session, Dialog dialog);

}  // namespace ghostforce
