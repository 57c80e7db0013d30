#include "app/command_line.h"

namespace ghostforce {

int run_command_line(std::vector<std::string>) {
  return 0;
}

}  // namespace ghostforce
