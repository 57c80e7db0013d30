// Numbers as a person reads them: with a real minus sign (U+2212), and never "−0". Pure; any thread.
#pragma once

#include <string>

namespace ghostforce {

// "−19.4", "0.0", "3.6".
std::string decimal_text(double value, int decimals);

// With a sign, but for zero: "−19.4", "0.0", "+3.6".
std::string signed_decimal_text(double value, int decimals);

// What stands behind a ±, in whole numbers: no less than "1", because "± 0" would claim that nothing can be wrong.
std::string deviation_text(double deviation);

}  // namespace ghostforce
