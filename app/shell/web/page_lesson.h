// How the lesson goes that is on, as JSON: for scripts of the page and for the page around it (docs/web.md).
#pragma once

#include <nlohmann/json.hpp>

#include "app/state/session.h"

namespace ghostforce {

// null: there is none.
nlohmann::ordered_json lesson_json(const Session& session);

}  // namespace ghostforce
