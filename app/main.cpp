#include <exception>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "app/command_line.h"
#include "app/failure.h"

int main(int argc, char** argv) {
  using namespace ghostforce;
  try {
    return run_command_line(std::vector<std::string>(argv + 1, argv + argc));
  } catch (const Failure& failure) {
    fmt::print(stderr, "{}\n", failure.what());
    return static_cast<int>(failure.code());
  }
}
