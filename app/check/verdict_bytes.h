// A verdict on its way from one process of this program to another. Pure, any thread.
#pragma once

#include <string>
#include <string_view>

#include "app/check/verdict.h"

namespace ghostforce {

std::string bytes_of(const Verdict& verdict);

// Of the same build, by the function above.
Verdict verdict_of(std::string_view bytes);

}  // namespace ghostforce
