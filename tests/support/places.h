// Where the checkout and the program are. One source knows it (places.cpp), so that what a compiler's cache holds of all
// others serves every checkout.
#pragma once

#include <string>
#include <string_view>

namespace ghostforce {

// source_path("/docs/check.md"): the absolute path of a file of the checkout; of the checkout itself without one.
std::string source_path(std::string_view beneath = {});

// The absolute path of the program under test.
const std::string& ghostforce_program();

}  // namespace ghostforce
