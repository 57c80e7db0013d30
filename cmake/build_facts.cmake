# How the desktop program was built, for `ghostforce --version`: <ghostforce_build.h>.

# ---- The commit ------------------------------------------------------------------------------------------------------

# The commit that is checked out; a new one configures anew.
set(GHOSTFORCE_COMMIT "")
find_package(Git QUIET)
if(Git_FOUND AND EXISTS ${PROJECT_SOURCE_DIR}/.git)
  execute_process(
    COMMAND ${GIT_EXECUTABLE} rev-parse --short=12 HEAD
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
    OUTPUT_VARIABLE GHOSTFORCE_COMMIT OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  execute_process(
    COMMAND ${GIT_EXECUTABLE} rev-parse --path-format=absolute --git-path logs/HEAD
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
    OUTPUT_VARIABLE log_of_commits OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(EXISTS "${log_of_commits}")
    set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${log_of_commits})
  endif()
endif()

# ---- The libraries, with the versions that it is built with ----------------------------------------------------------

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

set(libraries
  "Dear ImGui ${imgui_version}"
  "ImPlot ${implot_version}"
  "GLFW ${glfw_version}"
  "Cairo ${cairo_version}"
  "FreeType ${FREETYPE_VERSION_STRING}"
  "libpng ${PNG_VERSION_STRING}"
  "zlib ${ZLIB_VERSION_STRING}"
  "libusb ${LIBUSB_VERSION}"
  "hidapi ${HIDAPI_VERSION}"
  "OpenSSL ${OPENSSL_VERSION}"
  "GLM ${glm_VERSION}"
  "fmt ${fmt_VERSION}"
  "toml++ ${tomlplusplus_VERSION}"
  "JSON for Modern C++ ${nlohmann_json_VERSION}"
  "CLI11 ${CLI11_VERSION}")

# ----------------------------------------------------------------------------------------------------------------------

set(build_type ${CMAKE_BUILD_TYPE})
if(GHOSTFORCE_SANITIZE)
  string(APPEND build_type " with sanitizers: ${GHOSTFORCE_SANITIZE}")
endif()
list(JOIN libraries ", " library_words)
configure_file(${PROJECT_SOURCE_DIR}/cmake/ghostforce_build.h.in ${PROJECT_BINARY_DIR}/generated/ghostforce_build.h)
