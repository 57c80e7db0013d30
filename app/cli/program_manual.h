// The program's manual (app/tools/manual), from what its commands tell CLI11. Allocates; not for the servo thread.
#pragma once

#include "app/tools/manual/manual.h"

namespace ghostforce {

Manual program_manual();

}  // namespace ghostforce
