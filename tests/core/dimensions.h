// The model has no dimension, so its tests run in each that core/ is built for: TYPED_TEST_SUITE(Suite, Dimensions,
// DimensionName), with TypeParam::value for D. A test is then called Suite/2D.name, Suite/3D.name, Suite/4D.name.
#pragma once

#include <string>
#include <type_traits>

#include <gtest/gtest.h>
#include <glm/detail/setup.hpp>

namespace ghostforce {

using Dimensions = testing::Types<std::integral_constant<glm::length_t, 2>, std::integral_constant<glm::length_t, 3>,
                                  std::integral_constant<glm::length_t, 4>>;

struct DimensionName {
  template <typename Dimension>
  static std::string GetName(int) {
    return std::to_string(Dimension::value) + "D";
  }
};

}  // namespace ghostforce
