// A scene file, and after each 0 byte an argument of --set: what is read can be written, and reads back the same.
#include <string>
#include <vector>

#include "app/files/scene_file.h"
#include "tests/fuzz/fuzz.h"
#include "tests/support/scene_values.h"

using namespace ghostforce;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string_view rest = text_of({data, size});
  const std::string_view text = rest.substr(0, rest.find('\0'));
  std::vector<std::string> overrides;
  for (std::size_t at = text.size(); at < rest.size() && overrides.size() < 8; at = rest.find('\0', at)) {
    ++at;
    overrides.emplace_back(rest.substr(at, rest.find('\0', at) - at));
    if (rest.find('\0', at) == std::string_view::npos) break;
  }

  Scene scene;
  try {
    scene = read_scene(text, "fuzz.toml", overrides);
  } catch (const ReadError& error) {
    require(error.kind() == ReadError::Kind::wrong, "a text that is no scene says something wrong");
    require(*error.what() != '\0', "it is said what is wrong");
    for (const char c : std::string_view(error.what())) {
      require(c == '\n' || (static_cast<unsigned char>(c) >= 0x20 && c != 0x7F), "no message moves a cursor");
    }
    return 0;
  }
  require(is_in_range(scene.settings) && !find_problem(scene), "what is read is valid");
  require(scene_values(rounded_to_file(scene)) == scene_values(scene), "a file can hold what a file has told");
  const std::string written = scene_text(scene);
  const Scene again = read_scene(written, "written.toml");
  require(scene_values(again) == scene_values(scene), "what is written reads back bit for bit");
  require(scene_text(again) == written, "it is written the same way again");
  return 0;
}
