// Words of people, which may hold anything, in XML and HTML. Pure, any thread.
#pragma once

#include <string>
#include <string_view>

namespace ghostforce {

// For text and attributes of XML 1.0 and HTML. Whatever XML forbids even when escaped (most control characters, U+FFFE,
// U+FFFF) and each byte that is no UTF-8 is left out; U+FFFD, the sign for that, stands in its place.
std::string xml_text(std::string_view text);

}  // namespace ghostforce
