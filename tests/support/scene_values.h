// Every value of a scene in a row, key by key, so that two scenes can be compared bit for bit and a difference be
// named.
#pragma once

#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "core/scene.h"

namespace ghostforce {

// "table.name: bits…" for each key.
inline std::vector<std::string> scene_values(Scene scene) {
  std::vector<std::string> values;
  for (const SceneKey& key : scene_keys()) {
    std::string value = fmt::format("{}.{}:", key.table, key.name);
    const auto add = [&](double number) { value += fmt::format(" {:x}", std::bit_cast<std::uint64_t>(number)); };
    struct Visitor {
      Scene& of;
      std::string& into;
      decltype(add)& with;
      void operator()(const NumberKey& k) const { with(k.in(of)); }
      void operator()(const OptionalNumberKey& k) const {
        if (k.in(of)) {
          with(*k.in(of));
        } else {
          into += " empty";
        }
      }
      void operator()(const TextKey& k) const { into += fmt::format(" {}", k.in(of)); }
      void operator()(const ChoiceKey& k) const { into += fmt::format(" {}", words_of(k, of)[k.get(of)]); }
      void operator()(const PointKey& k) const {
        with(k.in(of).x);
        with(k.in(of).y);
      }
      void operator()(const PointsKey& k) const {
        for (const Vector<2>& point : k.in(of)) {
          with(point.x);
          with(point.y);
        }
      }
      void operator()(const TimesKey& k) const {
        for (const double time : k.in(of)) with(time);
      }
      void operator()(const NumbersKey& k) const {
        for (const double number : k.in(of)) with(number);
      }
      void operator()(const RangeKey& k) const {
        with(k.in(of).least);
        with(k.in(of).greatest);
      }
      void operator()(const PairKey& k) const {
        for (const double number : k.in(of)) with(number);
      }
      void operator()(const PointPairKey& k) const {
        for (const Vector<2>& point : k.in(of)) {
          with(point.x);
          with(point.y);
        }
      }
      void operator()(const AnchorsKey& k) const {
        for (std::size_t i = 0; i < k.in(of).count; ++i) {
          with(k.in(of).anchors[i].x);
          with(k.in(of).anchors[i].y);
        }
      }
    };
    std::visit(Visitor{scene, value, add}, key.value);
    values.push_back(value);
  }
  return values;
}

}  // namespace ghostforce
