#include "app/check/verdict_bytes.h"

#include <cstring>
#include <optional>
#include <tuple>
#include <type_traits>

namespace ghostforce {
namespace {

// Every member of these, for both ways. A member that is forgotten here does not compile.
auto members_of(auto& value) {
  using Type = std::remove_cvref_t<decltype(value)>;
  if constexpr (std::is_same_v<Type, Verdict>) {
    auto& [name, passes, is_file_trouble, is_lenient, tolerance, reason, remark, remedy, comparison, drawn_by,
           duration_s, pictures] = value;
    return std::tie(name, passes, is_file_trouble, is_lenient, tolerance, reason, remark, remedy, comparison, drawn_by,
                    duration_s, pictures);
  } else if constexpr (std::is_same_v<Type, GoldenOrigin>) {
    auto& [renderer, mesa, version] = value;
    return std::tie(renderer, mesa, version);
  } else {
    static_assert(std::is_same_v<Type, VerdictPictures>);
    auto& [expected, actual, difference] = value;
    return std::tie(expected, actual, difference);
  }
}

template <typename Value>
void append(std::string& bytes, const Value& value) {
  if constexpr (std::is_trivially_copyable_v<Value>) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  } else if constexpr (std::is_same_v<Value, std::string>) {
    append(bytes, value.size());
    bytes += value;
  } else if constexpr (std::is_same_v<Value, std::optional<std::string>>) {
    append(bytes, value.has_value());
    if (value) append(bytes, *value);
  } else {
    std::apply([&](const auto&... each) { (append(bytes, each), ...); }, members_of(value));
  }
}

std::string_view take(std::string_view& bytes, std::size_t count) {
  const std::string_view taken = bytes.substr(0, count);
  bytes.remove_prefix(count);
  return taken;
}

template <typename Value>
void extract(std::string_view& bytes, Value& value) {
  if constexpr (std::is_trivially_copyable_v<Value>) {
    std::memcpy(&value, take(bytes, sizeof value).data(), sizeof value);
  } else if constexpr (std::is_same_v<Value, std::string>) {
    std::size_t size = 0;
    extract(bytes, size);
    value = take(bytes, size);
  } else if constexpr (std::is_same_v<Value, std::optional<std::string>>) {
    bool is_there = false;
    extract(bytes, is_there);
    if (is_there) extract(bytes, value.emplace());
  } else {
    std::apply([&](auto&... each) { (extract(bytes, each), ...); }, members_of(value));
  }
}

}  // namespace

std::string bytes_of(const Verdict& verdict) {
  std::string bytes;
  append(bytes, verdict);
  return bytes;
}

Verdict verdict_of(std::string_view bytes) {
  Verdict verdict;
  extract(bytes, verdict);
  return verdict;
}

}  // namespace ghostforce
