# The libraries in the desktop program, each with the version that it was built with: `ghostforce --version` tells them,
# and the bill of materials lists them.
#
#   GHOSTFORCE_LIBRARIES    a list of "NAME VERSION|LICENCE", the licence as SPDX names it

# version_in(OUT HEADER PREFIX PART...): the numbers that a header defines as PREFIX_PART, with points between them.
function(version_in out header prefix)
  set(numbers "")
  foreach(part IN LISTS ARGN)
    file(STRINGS ${header} line REGEX "^#define ${prefix}_${part}[ \t]+[0-9]+$" LIMIT_COUNT 1)
    string(REGEX REPLACE ".*[ \t]" "" number "${line}")
    list(APPEND numbers ${number})
  endforeach()
  list(JOIN numbers . version)
  set(${out} ${version} PARENT_SCOPE)
endfunction()

version_in(cairo_version ${CAIRO_INCLUDE_DIR}/cairo-version.h CAIRO_VERSION MAJOR MINOR MICRO)

# A package tells its version; the wheel's headers do.
if(imgui_wheel_dir)
  version_in(glfw_version ${imgui_wheel_dir}/include/GLFW/glfw3.h GLFW_VERSION MAJOR MINOR REVISION)
  foreach(library IN ITEMS imgui implot)
    string(TOUPPER ${library} prefix)
    file(STRINGS ${imgui_wheel_dir}/include/${library}.h line REGEX "^#define ${prefix}_VERSION[ \t]+\"")
    string(REGEX REPLACE ".*\"([0-9.]+).*" "\\1" ${library}_version "${line}")
  endforeach()
else()
  set(glfw_version ${glfw3_VERSION})
  set(imgui_version ${imgui_VERSION})
  set(implot_version ${implot_VERSION})
endif()

set(GHOSTFORCE_LIBRARIES
  "Dear ImGui ${imgui_version}|MIT"
  "ImPlot ${implot_version}|MIT"
  "GLFW ${glfw_version}|Zlib"
  "Cairo ${cairo_version}|LGPL-2.1-only OR MPL-1.1"
  "FreeType ${FREETYPE_VERSION_STRING}|FTL OR GPL-2.0-or-later"
  "libpng ${PNG_VERSION_STRING}|libpng-2.0"
  "zlib ${ZLIB_VERSION_STRING}|Zlib"
  "libusb ${LIBUSB_VERSION}|LGPL-2.1-or-later"
  "hidapi ${HIDAPI_VERSION}|BSD-3-Clause"
  "OpenSSL ${OPENSSL_VERSION}|Apache-2.0"
  "GLM ${glm_VERSION}|MIT"
  "fmt ${fmt_VERSION}|MIT"
  "toml++ ${tomlplusplus_VERSION}|MIT"
  "JSON for Modern C++ ${nlohmann_json_VERSION}|MIT"
  "CLI11 ${CLI11_VERSION}|BSD-3-Clause")
