#include "device/realtime.h"

#include <cerrno>

#include <gtest/gtest.h>

namespace ghostforce {
namespace {

TEST(Realtime, SaysWhatWasGranted) {
  EXPECT_EQ(describe({0, 0}), "real-time priority, memory locked");
}

TEST(Realtime, SaysWhatWasNotAndWhy) {
  EXPECT_EQ(describe({EPERM, EPERM}),
            "no real-time priority (Operation not permitted), memory not locked (Operation not permitted)");
  EXPECT_EQ(describe({0, ENOMEM}), "real-time priority, memory not locked (Cannot allocate memory)");
}

}  // namespace
}  // namespace ghostforce
