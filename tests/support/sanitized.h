// Whether a sanitizer is built in, which takes memory and allocates as no program does. g++ says so in macros, clang
// answers a question. For tests.
#pragma once

#if defined(__SANITIZE_ADDRESS__)
#define GHOSTFORCE_ADDRESS_SANITIZED
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define GHOSTFORCE_SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define GHOSTFORCE_ADDRESS_SANITIZED
#endif
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define GHOSTFORCE_SANITIZED
#endif
#endif
