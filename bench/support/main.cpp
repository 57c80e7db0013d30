#include <cstdio>
#include <exception>

#include "bench/support/report.h"

int main(int argc, char** argv) {
  try {
    return ghostforce::bench::run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 70;
  }
}
