// Which build of the program this is, as the files that it writes name it. Pure, any thread.
#pragma once

#include <string>

namespace ghostforce {

// "0.2.0" on a desktop, "0.2.0, page" in a browser. Desktop builds of one version have one name, whatever compiled them
// for whatever processor.
std::string program_build();

}  // namespace ghostforce
