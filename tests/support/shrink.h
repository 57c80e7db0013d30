// The shortest part of a list that still fails, for whoever has to find out why.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

namespace ghostforce {

// `fails` is asked about lists with the order kept and parts left out; it must be true of the whole one. Of what is
// returned, nothing alone can be left out; but after `most_tries` it is what was found so far.
template <typename Item>
std::vector<Item> shrink(std::vector<Item> list, const std::function<bool(const std::vector<Item>&)>& fails,
                         int most_tries = 100'000) {
  int tries = 0;
  std::size_t size = std::max<std::size_t>(1, list.size() / 2);  // of what is left out at once
  for (bool is_shorter = true; size > 1 || is_shorter; size = std::max<std::size_t>(1, size / 2)) {
    is_shorter = false;
    for (std::size_t at = 0; at < list.size();) {
      if (tries++ == most_tries) return list;
      const auto from = list.begin() + static_cast<std::ptrdiff_t>(at);
      std::vector<Item> rest(list.begin(), from);
      rest.insert(rest.end(), from + static_cast<std::ptrdiff_t>(std::min(size, list.size() - at)), list.end());
      if (fails(rest)) {
        list = std::move(rest);
        is_shorter = true;
      } else {
        at += size;
      }
    }
  }
  return list;
}

}  // namespace ghostforce
