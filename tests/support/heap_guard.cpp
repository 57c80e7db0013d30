#include "tests/support/heap_guard.h"

#include <cerrno>
#include <cstddef>

#include <gtest/gtest.h>

#include "tests/support/sanitized.h"

namespace {

// Constant-initialised, so that reaching them never allocates.
constinit thread_local int guards = 0;
constinit thread_local std::uint64_t uses = 0;

void note_use() noexcept {
  if (guards > 0) ++uses;
}

}  // namespace

#ifdef GHOSTFORCE_SANITIZED

// The sanitizers bring a heap of their own, with a hook for each block that comes and goes.
extern "C" int __sanitizer_install_malloc_and_free_hooks(void (*malloc_hook)(const volatile void*, std::size_t),
                                                         void (*free_hook)(const volatile void*));

namespace {
[[maybe_unused]] const int hooks = __sanitizer_install_malloc_and_free_hooks(
    [](const volatile void*, std::size_t) { note_use(); }, [](const volatile void*) { note_use(); });
}  // namespace

#else

// These stand before those of glibc, for the program and for every library that it loads; `new` and `delete` come by
// here.
extern "C" {

// NOLINTBEGIN(bugprone-reserved-identifier, readability-identifier-naming): glibc's names
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* block);
// NOLINTEND(bugprone-reserved-identifier, readability-identifier-naming)

void* malloc(std::size_t size) {
  note_use();
  return __libc_malloc(size);
}

void* calloc(std::size_t count, std::size_t size) {
  note_use();
  return __libc_calloc(count, size);
}

void* realloc(void* block, std::size_t size) {
  note_use();
  return __libc_realloc(block, size);
}

void* memalign(std::size_t alignment, std::size_t size) {
  note_use();
  return __libc_memalign(alignment, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) {
  note_use();
  return __libc_memalign(alignment, size);
}

int posix_memalign(void** block, std::size_t alignment, std::size_t size) {
  note_use();
  void* const fresh = __libc_memalign(alignment, size);
  if (fresh == nullptr) return ENOMEM;
  *block = fresh;
  return 0;
}

void free(void* block) {
  note_use();
  __libc_free(block);
}

}  // extern "C"

#endif

namespace ghostforce {

HeapGuard::HeapGuard() noexcept : uses_before_(uses) {
  ++guards;
}

HeapGuard::~HeapGuard() {
  --guards;
  if (const std::uint64_t taken = take_uses(); taken != 0) {
    ADD_FAILURE() << "The heap was used " << taken << " times where it must not be.";
  }
}

std::uint64_t HeapGuard::take_uses() noexcept {
  const std::uint64_t taken = uses - uses_before_;
  uses_before_ = uses;
  return taken;
}

}  // namespace ghostforce
