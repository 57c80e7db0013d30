#include "app/session/front_keys.h"

#include "app/session/front_key_tables.h"

namespace ghostforce {

const FrontKeys& front_keys() noexcept {
  return keys_in_page;
}

}  // namespace ghostforce
