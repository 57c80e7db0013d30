// What a tick of a general scene tells beside its snapshot, for each strategy. Values, trivially copyable: they cross
// threads whole. The paper's scenes have none of it, so it stands apart.
#pragma once

#include <cstdint>

#include "core/actuation_matrix.h"
#include "core/strategy.h"

namespace ghostforce {

enum class ContactStatus : std::uint8_t {
  free,               // nothing acts
  contact,            // a wall does
  outside_workspace,  // the mechanism cannot stand there: no effort
  no_solution,        // the problem of contact_solver.h has none: no effort, and the proxy stays
};

struct ContactReading {
  Efforts efforts{};        // u of each motor [N or N·m]
  std::uint8_t active = 0;  // the walls that act, bit i for wall i
  ContactStatus status = ContactStatus::free;
};

using ContactReadings = PerStrategy<ContactReading>;

}  // namespace ghostforce
