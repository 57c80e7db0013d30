#include "app/state/front_keys.h"

namespace ghostforce {

const FrontKeys& front_keys() noexcept {
  return keys_in_page;
}

}  // namespace ghostforce
