// Binds a thread to the system calls that are named: from then on it may make no other. One that it tries all the
// same is not carried out; it is remembered, with its number, and the thread goes on. For good: the kernel takes no
// such promise back, so a test does it on a thread that ends with it. Linux, with seccomp; without special rights.
#pragma once

#include <span>
#include <vector>

namespace ghostforce {

// False: this kernel or container has no seccomp.
bool forbid_calls_but(std::span<const int> allowed) noexcept;

// The numbers of the calls that threads so bound have tried, each once; empty: none. Any thread.
std::vector<int> forbidden_calls();

}  // namespace ghostforce
