# What the page compiles itself, because Debian has it for its own processors only. It becomes the same targets that
# dependencies.cmake finds for the desktop.

# Of glm, fmt, toml++, nlohmann-json and stb the headers are enough; alone, because those beside them are not Emscripten's.
set(headers ${PROJECT_BINARY_DIR}/headers)
file(MAKE_DIRECTORY ${headers})
foreach(folder IN ITEMS fmt glm nlohmann stb toml++)
  file(CREATE_LINK /usr/include/${folder} ${headers}/${folder} SYMBOLIC)
endforeach()
add_library(page_headers INTERFACE)
target_include_directories(page_headers SYSTEM INTERFACE ${headers})
# No comma of another language, for which fmt would bring in all of the standard library's locales.
target_compile_definitions(page_headers INTERFACE FMT_HEADER_ONLY FMT_STATIC_THOUSANDS_SEPARATOR=',')
foreach(library IN ITEMS glm::glm fmt::fmt nlohmann_json::nlohmann_json tomlplusplus::tomlplusplus)
  add_library(${library} ALIAS page_headers)
endforeach()

# unpack(ARCHIVE SHA256 NAME OUT PATTERN...): unpacks these files of an archive that must be exactly this one, once.
function(unpack archive sha256 name out)
  set(unpacked ${GHOSTFORCE_DOWNLOAD_DIR}/${name})
  set(${out} ${unpacked} PARENT_SCOPE)
  if(EXISTS ${unpacked})
    return()
  endif()
  file(SHA256 ${archive} found)
  if(NOT found STREQUAL sha256)
    message(FATAL_ERROR "${archive} is not the file that this program was tried with: its SHA-256 is\n${found}, not\n${sha256}.")
  endif()
  # Unpack beside, then rename: an interrupted run leaves no half-filled directory behind.
  set(scratch ${PROJECT_BINARY_DIR}/unpacking)
  file(REMOVE_RECURSE ${scratch})
  file(ARCHIVE_EXTRACT INPUT ${archive} DESTINATION ${scratch} PATTERNS ${ARGN})
  file(GLOB top ${scratch}/*)
  file(RENAME ${top} ${unpacked})
  file(REMOVE_RECURSE ${scratch})
endfunction()

# ---- Dear ImGui and ImPlot -------------------------------------------------------------------------------------------

unpack(${GHOSTFORCE_DOWNLOAD_DIR}/imgui_bundle-${imgui_bundle_version}.tar.gz ${imgui_bundle_sha256}
  imgui-bundle-${imgui_bundle_version} bundle
  "*/external/imgui/imgui/*.h" "*/external/imgui/imgui/*.cpp" "*/external/imgui/imgui/backends/imgui_impl_opengl3*"
  "*/external/implot/implot/*.h" "*/external/implot/implot/*.cpp")
set(imgui ${bundle}/external/imgui/imgui)
set(implot ${bundle}/external/implot/implot)
add_library(imgui_sources STATIC
  ${imgui}/imgui.cpp ${imgui}/imgui_draw.cpp ${imgui}/imgui_stacklayout.cpp ${imgui}/imgui_tables.cpp
  ${imgui}/imgui_widgets.cpp ${imgui}/backends/imgui_impl_opengl3.cpp ${implot}/implot.cpp ${implot}/implot_items.cpp
  ${PROJECT_SOURCE_DIR}/app/paint/web/imgui_state.cpp)
# Of ImGui, what builds each frame's triangles.
set_property(SOURCE ${imgui}/imgui_draw.cpp APPEND PROPERTY COMPILE_OPTIONS $<$<CONFIG:MinSizeRel>:-O2>)
set_property(SOURCE ${imgui}/backends/imgui_impl_opengl3.cpp APPEND PROPERTY
  COMPILE_OPTIONS -include ${PROJECT_SOURCE_DIR}/app/paint/web/imgui_state.h)
target_include_directories(imgui_sources PRIVATE ${PROJECT_SOURCE_DIR})
target_include_directories(imgui_sources SYSTEM PUBLIC ${imgui} ${imgui}/backends ${implot})
target_compile_features(imgui_sources PUBLIC cxx_std_20)
target_compile_definitions(imgui_sources PUBLIC
  IMPLOT_CUSTOM_NUMERIC_TYPES=\(double\)  # of all the types that its plots are templates of
  IMGUI_DISABLE_DEMO_WINDOWS IMGUI_DISABLE_DEBUG_TOOLS IMGUI_DISABLE_DEFAULT_FONT
  PRIVATE IMGUI_IMPL_OPENGL_ES3)
add_library(ghostforce::gui ALIAS imgui_sources)
