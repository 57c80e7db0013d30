// A line that may be a set-up's: what is read can be written, and reads back the same.
#include <string>

#include "app/files/read_error.h"
#include "app/state/set_up.h"
#include "tests/fuzz/fuzz.h"
#include "tests/support/set_up_values.h"

using namespace ghostforce;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  SetUp set_up;
  try {
    set_up = read_set_up_line(text_of({data, size}));
  } catch (const ReadError& error) {
    require(error.kind() == ReadError::Kind::wrong, "a text that is no set-up says something wrong");
    require(*error.what() != '\0', "it is said what is wrong");
    for (const char c : std::string_view(error.what())) {
      require(c == '\n' || (static_cast<unsigned char>(c) >= 0x20 && c != 0x7F), "no message moves a cursor");
    }
    return 0;
  }
  const std::string line = set_up_line(set_up);
  require(set_up_values(read_set_up_line(line)) == set_up_values(set_up), "what is written reads back bit for bit");
  return 0;
}
