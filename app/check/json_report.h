// What `check --json` prints. Pure, any thread.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/check/case_file.h"
#include "app/check/report.h"
#include "app/check/verdict.h"

namespace ghostforce {

// One JSON document of all verdicts, as docs/check.md describes it; no newline at its end. `cases` are in the verdicts'
// order; `folder` is theirs; `report` is null where none was asked for.
std::string report_as_json(const std::vector<const Case*>& cases, const std::vector<Verdict>& verdicts,
                           std::string_view folder, const Report* report);

}  // namespace ghostforce
