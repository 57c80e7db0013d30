# fetch_imgui_wheel(OUT): downloads the wheel pinned in imgui-wheel-requirements.txt, unless it is already there, and sets
# OUT to the directory with its include/ and lib/. The wheel holds plain static libraries; Python only carries them.

# The presets share one download directory, so that four build trees fetch once.
set(GHOSTFORCE_DOWNLOAD_DIR ${PROJECT_BINARY_DIR}/downloads CACHE PATH "Where the ImGui wheel is unpacked")

function(fetch_imgui_wheel out)
  set(requirements ${PROJECT_SOURCE_DIR}/cmake/imgui-wheel-requirements.txt)
  set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${requirements})

  # The directory is named after what is pinned: another pin is another directory, and an old one is never mistaken.
  file(SHA256 ${requirements} pin)
  string(SUBSTRING ${pin} 0 12 pin)
  set(unpacked ${GHOSTFORCE_DOWNLOAD_DIR}/imgui-${CMAKE_SYSTEM_PROCESSOR}-${pin})
  set(${out} ${unpacked} PARENT_SCOPE)
  if(EXISTS ${unpacked})
    return()
  endif()

  message(STATUS "Fetching Dear ImGui, ImPlot and GLFW")
  set(scratch ${PROJECT_BINARY_DIR}/imgui-wheel)
  file(REMOVE_RECURSE ${scratch})
  # The Python version is the one that the wheel names; nothing of it is run.
  execute_process(
    COMMAND ${GHOSTFORCE_PYTHON} -m pip download --quiet --disable-pip-version-check
            --require-hashes --no-deps --only-binary=:all: --python-version 3.12
            --platform manylinux_2_28_${CMAKE_SYSTEM_PROCESSOR} --dest ${scratch} --requirement ${requirements}
    RESULT_VARIABLE failed
    ERROR_VARIABLE errors)
  if(failed)
    message(FATAL_ERROR
      "Dear ImGui, ImPlot and GLFW 3.4 could not be fetched. Either\n"
      "  - let pip reach its package index (network, proxy, certificates) and start again, or\n"
      "  - provide imgui, implot and glfw3 >= 3.4 as CMake packages, by vcpkg or Conan for instance, and name their "
      "place in CMAKE_PREFIX_PATH.\n"
      "The wheel exists for x86_64 and aarch64; this is ${CMAKE_SYSTEM_PROCESSOR}. pip is Debian's python3-pip. It said:\n"
      "${errors}")
  endif()

  # Unpack beside, then rename: an interrupted run leaves no half-filled directory behind.
  file(GLOB wheel ${scratch}/*.whl)
  file(ARCHIVE_EXTRACT INPUT ${wheel} DESTINATION ${scratch} PATTERNS "*/install/include/*" "*/install/lib/*.a")
  file(GLOB installed ${scratch}/*/purelib/imgui/install)
  file(MAKE_DIRECTORY ${GHOSTFORCE_DOWNLOAD_DIR})
  file(RENAME ${installed} ${unpacked})
  file(REMOVE_RECURSE ${scratch})
endfunction()
