// Writes marks as JSON: the same picture for a script, with positions in millimetres. Any thread.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/picture/marks.h"

namespace ghostforce {

// An array with one object per mark: role, strategy (where it belongs to one), form, and the form's positions, sizes
// and colours, of a raster without its cells. An arrow says where it has no head or is hatched, a label where its letters
// are bold or none of the three heights of the workbench.
nlohmann::ordered_json marks_as_json(const Marks& marks);

}  // namespace ghostforce
