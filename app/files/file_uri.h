// Paths of files as URIs have them (RFC 8089). Pure, any thread.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace ghostforce {

// The path that "file:///home/ana/my%20wall.toml" stands for; empty where the URI is another kind's, of another
// computer, or damaged.
std::optional<std::string> path_of_file_uri(std::string_view uri);

}  // namespace ghostforce
