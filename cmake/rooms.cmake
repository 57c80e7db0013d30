# ghostforce_add_room([SEPARATE] [COLD | LOOPS] [EACH_FRAME] [SOURCES file...] [DESKTOP file...] [PAGE file...])
#
# One folder as one CMake library, named after it: app/workbench is app_workbench. What it links is its line of rooms.txt,
# so that each folder can be built and tested by itself. That it includes no more is kept by the architecture test, which
# reads the same lines: links hand on, and what is inline needs none.
#
# Its sources are one batch (batches.cmake). SEPARATE: each is compiled by itself in every preset. COLD: where no frame
# and no tick spends time worth measuring, it is optimised less and compiled a third faster. EACH_FRAME: most of the
# page's script runs through it, which is optimised for speed there; the rest of the page is optimised for size.
# LOOPS: tests spend their time in it, and the presets asan and tsan optimise it. The rest is not optimised there, nor are
# tests: they are compiled in half the time, which is more than the tests lose.
#
# The program has two fronts, a desktop and a page in a browser. DESKTOP sources are compiled for the one only, PAGE
# sources for the other. Where both stand behind one header, x.h, the desktop's is x.cpp and the page's is x_page.cpp.

# What that file calls the libraries: dependencies.cmake finds them.
set(library_glm glm::glm)
set(library_fmt fmt::fmt)
set(library_tomlplusplus tomlplusplus::tomlplusplus)
set(library_nlohmann_json nlohmann_json::nlohmann_json)
set(library_imgui ghostforce::gui)
set(library_implot ghostforce::gui)
set(library_opengl ghostforce::opengl)
set(library_generated ghostforce::resources)
set(library_emscripten "")  # the page's compiler has it, and only sources of the page use it
if(EMSCRIPTEN)
  set(library_posix "")  # in Emscripten's C library
  set(library_libpng "")
  set(library_zlib "")
  set(library_hidapi "")
  set(library_stb page_headers)
else()
  set(library_posix Threads::Threads)
  set(library_libpng PNG::PNG)
  set(library_zlib ZLIB::ZLIB)
  set(library_stb "")
  set(library_libusb ghostforce::libusb)
  set(library_hidapi ghostforce::hidapi)
  set(library_libcrypto OpenSSL::Crypto)
  set(library_cli11 CLI11::CLI11)
  set(library_cairo ghostforce::cairo)
  set(library_glad ghostforce::glad)
  set(library_glfw ghostforce::gui)
  set(library_xcb ghostforce::xcb)
  set(library_libsystemd ghostforce::libsystemd)
endif()

set(rooms_file ${CMAKE_CURRENT_LIST_DIR}/rooms.txt)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${rooms_file})

# room_library(FOLDER RESULT): the name of its library.
function(room_library folder result)
  string(REPLACE "/" "_" name ${folder})
  set(${result} ${name} PARENT_SCOPE)
endfunction()

# room_links(FOLDER RESULT): what it links.
function(room_links folder result)
  file(STRINGS ${rooms_file} line REGEX "^${folder} +\\|")
  if(NOT line)
    message(FATAL_ERROR "${folder} has no line in cmake/rooms.txt: say there what it may include.")
  endif()
  string(REPLACE "|" ";" cells "${line}")
  list(GET cells 1 folders)
  list(GET cells 2 libraries)
  string(REGEX MATCHALL "[^ ]+" folders "${folders}")
  string(REGEX MATCHALL "[^ ]+" libraries "${libraries}")
  set(links "")
  foreach(other IN LISTS folders)
    room_library(${other} library)
    list(APPEND links ${library})
  endforeach()
  foreach(library IN LISTS libraries)
    if(NOT DEFINED library_${library})
      message(FATAL_ERROR "cmake/rooms.txt: ${folder} wants ${library}, which is no library that cmake/rooms.cmake knows.")
    endif()
    list(APPEND links ${library_${library}})
  endforeach()
  list(REMOVE_DUPLICATES links)
  set(${result} "${links}" PARENT_SCOPE)
endfunction()

function(ghostforce_add_room)
  cmake_parse_arguments(PARSE_ARGV 0 arg "SEPARATE;COLD;LOOPS;EACH_FRAME" "" "SOURCES;DESKTOP;PAGE")
  cmake_path(RELATIVE_PATH CMAKE_CURRENT_SOURCE_DIR BASE_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE folder)
  room_library(${folder} name)
  room_links(${folder} links)
  if(NOT ARGN)  # headers alone
    add_library(${name} INTERFACE)
    target_link_libraries(${name} INTERFACE ${links})
    return()
  endif()
  if(EMSCRIPTEN)
    set(own ${arg_PAGE})
  else()
    set(own ${arg_DESKTOP})
  endif()
  set(sources ${arg_SOURCES} ${own})
  if(NOT arg_SEPARATE)
    list(LENGTH sources size)
    ghostforce_batches(sources ${name} ${size} ${sources})
  endif()
  add_library(${name} STATIC ${sources})
  target_link_libraries(${name} PUBLIC ${links} project_options PRIVATE project_warnings batch_warnings)
  if(arg_COLD)
    target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O1>)
  endif()
  if(arg_EACH_FRAME)
    target_compile_options(${name} PRIVATE $<$<CONFIG:MinSizeRel>:-O2>)
  endif()
  if(arg_LOOPS AND GHOSTFORCE_SANITIZE)
    target_compile_options(${name} PRIVATE $<$<CONFIG:RelWithDebInfo>:-O1>)
  endif()
endfunction()
