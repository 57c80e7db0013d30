# How the project's own code is compiled. A target of ours says
#
#   target_link_libraries(core PUBLIC project_options PRIVATE project_warnings)
#
# Only the build type's default and the sanitizers act on everything; all other flags travel with these two targets, so
# that generated and third-party code keeps its own.

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Debug, Release, RelWithDebInfo or MinSizeRel" FORCE)
endif()

set(CMAKE_CXX_EXTENSIONS OFF)

# Sanitizers come before any target: a program that mixes instrumented and plain objects reports nonsense.
set(GHOSTFORCE_SANITIZE "" CACHE STRING
  "Sanitizers: empty, address (with undefined behaviour), thread, or fuzzer (address, and clang's libFuzzer)")
set_property(CACHE GHOSTFORCE_SANITIZE PROPERTY STRINGS "" address thread fuzzer)
if(GHOSTFORCE_SANITIZE STREQUAL "address")
  # Two checks of pointers are left out: compiling takes a fifth longer with them. An access through a null pointer the
  # address sanitizer sees too, and casts to what needs a stricter alignment are warned of.
  set(sanitize -fsanitize=address,undefined -fno-sanitize=null,alignment -fno-sanitize-recover=all)
elseif(GHOSTFORCE_SANITIZE STREQUAL "thread")
  set(sanitize -fsanitize=thread)
elseif(GHOSTFORCE_SANITIZE STREQUAL "fuzzer")
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    message(FATAL_ERROR "libFuzzer is clang's: use the preset fuzz, or set CMAKE_CXX_COMPILER.")
  endif()
  # Only the programs in tests/fuzz have libFuzzer's main(); all code tells it where it has been.
  set(sanitize -fsanitize=fuzzer-no-link,address,undefined,float-cast-overflow -fno-sanitize-recover=all)
elseif(NOT GHOSTFORCE_SANITIZE STREQUAL "")
  message(FATAL_ERROR "GHOSTFORCE_SANITIZE is \"${GHOSTFORCE_SANITIZE}\"; it can be empty, address, thread or fuzzer.")
endif()
if(GHOSTFORCE_SANITIZE)
  add_compile_options(${sanitize} -fno-omit-frame-pointer)
  add_link_options(${sanitize})
endif()
if(GHOSTFORCE_SANITIZE STREQUAL "address")
  # Into every program, ahead of the system's dlclose: the linker takes the object for the sake of the marker in it.
  add_library(keep_libraries_loaded STATIC ${PROJECT_SOURCE_DIR}/cmake/keep_libraries_loaded.c)
  link_libraries(keep_libraries_loaded)
  add_link_options(LINKER:--undefined=ghostforce_keeps_libraries_loaded)
endif()

# A quicker linker where there is one, for trees with tests, which are a hundred programs. ./package has none of them.
if(BUILD_TESTING AND NOT CMAKE_CROSSCOMPILING)
  find_program(GHOSTFORCE_MOLD mold)
  if(GHOSTFORCE_MOLD)
    add_link_options(-fuse-ld=mold)
  endif()
endif()

add_library(project_options INTERFACE)
target_compile_features(project_options INTERFACE cxx_std_20)
# Includes are written from the root, "core/wall.h", so that an include line shows which room it reaches into.
target_include_directories(project_options INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(project_options INTERFACE
  # Fused multiply-adds round differently from machine to machine; without them results and pictures are the same.
  -ffp-contract=off
  # Nothing reads errno after a maths function; std::sqrt becomes one instruction. Results do not change.
  -fno-math-errno
  # g++ first frees memory when it has 512 MB, not 128: a tenth faster, with up to 400 MB more for a process.
  $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=524288>)

if(EMSCRIPTEN)
  # Of all code: exceptions as the browser has them. Small first, for the page is sent by mail.
  add_compile_options(-fwasm-exceptions)
  add_link_options(-fwasm-exceptions)
endif()

option(GHOSTFORCE_BENCH "Build the programs in bench/, which measure how long things take" OFF)

option(GHOSTFORCE_WARNINGS_AS_ERRORS "Treat the warnings of our own code as errors (CI does)" OFF)
add_library(project_warnings INTERFACE)
target_compile_options(project_warnings INTERFACE
  -Wall -Wextra -Wpedantic
  -Wconversion -Wsign-conversion
  -Wshadow -Wold-style-cast -Wcast-align -Wcast-qual
  -Wnon-virtual-dtor -Woverloaded-virtual -Wextra-semi
  -Wformat=2 -Wimplicit-fallthrough -Wundef -Wunused
  $<$<CXX_COMPILER_ID:GNU>:-Wduplicated-cond -Wduplicated-branches -Wlogical-op>
  # clang warns of double to long double too, in which tests compute what they expect.
  $<$<CXX_COMPILER_ID:GNU>:-Wdouble-promotion>
  $<$<BOOL:${GHOSTFORCE_WARNINGS_AS_ERRORS}>:-Werror>)
