// The udev rule by which a person at the machine may open the devices: where it is installed, and how it gets there.
// UI thread.
#pragma once

#include <filesystem>
#include <span>
#include <string_view>

namespace ghostforce {

inline constexpr std::string_view udev_rule_name = "70-ghostforce.rules";
inline constexpr std::string_view udev_rule_folder = "/etc/udev/rules.d";  // of what an administrator adds

std::string_view udev_rule_text() noexcept;

// Where udev looks, the first of equal names first.
std::span<const std::string_view> udev_folders() noexcept;

// The file that is installed in one of these folders; empty: none.
std::filesystem::path installed_udev_rule(std::span<const std::string_view> folders);

// Puts it there for all to read, whole or not at all; returns its path. Throws Failure(file_trouble).
std::filesystem::path write_udev_rule(const std::filesystem::path& folder);

// Tells what will be done, becomes root for that alone where it has to and a person can be asked, and does it. Throws
// Failure(file_trouble) with the commands to type where nobody can be asked. `is_announced`: a call of this very
// function has told it already.
void install_udev_rule(bool is_announced);

}  // namespace ghostforce
