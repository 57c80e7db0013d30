// Finding things on the workbench: the scene picker, the top bar, what the status bar says, the clipboard.
#include "tests/app/live/driven_window.h"

namespace ghostforce {
namespace {

class FindingThings : public DrivenWindow {};

}  // namespace
}  // namespace ghostforce
