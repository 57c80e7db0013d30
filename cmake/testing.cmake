# ghostforce_add_test(name SOURCES file... [SUPPORT name...] [LIBRARIES target...] [LABELS label...] [LAUNCHER command...]
#                     [SHARDS count] [SECONDS count] [EACH] [WAITS] [SERIAL])
#
# One GoogleTest program. ctest runs it whole, in one process or in SHARDS of them side by side. With
# GHOSTFORCE_TEST_BY_TEST in the environment each of its tests is one of ctest, named program.Suite.test: that is how
# ./check -R finds a single one.
#
# SUPPORT   files of tests/support without their ending; `program` also builds ghostforce
# LABELS    tsan: threads meet in it, and .ci/run tests it under the thread sanitizer too
#           asan: .ci/run tests it under the address sanitizer; .ci/long tests all programs so
#           Both are one label of ctest, tsan+asan.
#           long: for .ci/long alone (cmake/setup.sh)
# SECONDS   what one process of it takes, where that is more than two: the slowest start first
# EACH      a process for each test in every case, because the process is what is tested
# WAITS     for devices and other processes more than it computes: twice as many of these run side by side. So a test
#           counts as two of the slots that run_tests (setup.sh) gives, one that waits as one.
# SERIAL    nothing else runs beside it
#
# Sources are compiled eight at a time (batches.cmake), and each has a namespace of its own, named after it.

include(GoogleTest)

add_custom_target(tsan_tests COMMENT "The tests labelled tsan, without building the others")
add_custom_target(asan_tests COMMENT "The tests labelled asan, without building the others")
add_custom_target(long_tests COMMENT "The tests labelled long, without building the others")

# What all tests include, compiled once, and what all of them are linked with.
set(test_options project_options project_warnings batch_warnings GTest::gtest glm::glm fmt::fmt Threads::Threads)
set(test_compile_options $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>
  $<$<CXX_COMPILER_ID:Clang>:SHELL:-Xclang -fno-pch-timestamp>)
set_property(SOURCE ${PROJECT_SOURCE_DIR}/tests/support/places.cpp PROPERTY COMPILE_DEFINITIONS
  GHOSTFORCE_SOURCE_DIR="${PROJECT_SOURCE_DIR}" GHOSTFORCE_PROGRAM="$<TARGET_FILE:ghostforce>")
function(add_test_headers name)
  add_library(${name} OBJECT
    ${PROJECT_SOURCE_DIR}/tests/support/left_as_found.cpp
    ${PROJECT_SOURCE_DIR}/tests/support/places.cpp)
  target_link_libraries(${name} PRIVATE ${test_options})
  target_compile_options(${name} PRIVATE ${test_compile_options} ${ARGN})
  target_precompile_headers(${name} PRIVATE
    <algorithm> <array> <chrono> <cmath> <cstdint> <filesystem> <functional> <map> <memory> <optional> <set> <sstream>
    <string> <string_view> <thread> <variant> <vector> <fmt/format.h> <glm/glm.hpp> <gtest/gtest.h>)
endfunction()
add_test_headers(test_headers)
# The tests of what a person sees and types say what is to happen, and leave computing to what they test: not optimised,
# they are compiled a quarter faster. Those of the model, half of which is in headers, and of devices are optimised.
set(app_test_headers test_headers)
set(app_test_options "")
if(CMAKE_BUILD_TYPE STREQUAL "Release" AND NOT CMAKE_CROSSCOMPILING)  # an emulator would take longer than the compiler
  set(app_test_headers app_test_headers)
  set(app_test_options -O0)
  add_test_headers(app_test_headers ${app_test_options})
endif()

# Not of a library that is linked as a whole: an object that replaces the heap must come with those that ask for it only.
foreach(support IN ITEMS animated_png_reader before_waiting call_guard display file_calls hand_at_wall heap_guard program)
  add_library(test_${support} OBJECT ${PROJECT_SOURCE_DIR}/tests/support/${support}.cpp)
  target_link_libraries(test_${support} PRIVATE ${test_options})
endforeach()

# The target starts that program: it is linked after it, and compiled whenever there is time.
function(ghostforce_starts target program)
  set_property(TARGET ${target} APPEND PROPERTY LINK_DEPENDS $<TARGET_FILE:${program}>)
endfunction()

function(ghostforce_add_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "EACH;SERIAL;WAITS" "SHARDS;SECONDS" "SOURCES;SUPPORT;LIBRARIES;LABELS;LAUNCHER")
  if(NOT arg_SOURCES OR arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "ghostforce_add_test(${name}): want SOURCES; got \"${ARGV}\"")
  endif()
  ghostforce_batches(sources ${name} 8 ${arg_SOURCES})
  add_executable(${name} ${sources})
  set(headers test_headers)
  set(options "")
  if(CMAKE_CURRENT_SOURCE_DIR MATCHES "/tests/app/")
    set(headers ${app_test_headers})
    set(options ${app_test_options})
  endif()
  target_precompile_headers(${name} REUSE_FROM ${headers})
  target_compile_options(${name} PRIVATE ${test_compile_options} ${options})
  list(TRANSFORM arg_SUPPORT PREPEND test_ OUTPUT_VARIABLE support)
  target_link_libraries(${name} PRIVATE ${arg_LIBRARIES} ${support} ${headers} GTest::gtest_main ${test_options})
  if(program IN_LIST arg_SUPPORT)
    ghostforce_starts(${name} ghostforce)
  endif()
  foreach(label IN LISTS arg_LABELS)
    add_dependencies(${label}_tests ${name})
  endforeach()
  if(arg_LAUNCHER)
    # CMake's name for it, from the days when only another machine's programs had one.
    set_property(TARGET ${name} PROPERTY CROSSCOMPILING_EMULATOR ${arg_LAUNCHER})
  endif()

  # A limit for what hangs, far above what any of them takes on a busy machine.
  set(properties TIMEOUT 1200 RUN_SERIAL ${arg_SERIAL})
  if(NOT arg_WAITS)
    list(APPEND properties PROCESSORS 2)
  endif()
  if(arg_SECONDS)
    list(APPEND properties COST ${arg_SECONDS})
  endif()
  if(arg_LABELS)
    list(JOIN arg_LABELS + label)  # one, as a list would fall apart below
    list(APPEND properties LABELS ${label})
  endif()

  # PRE_TEST lists the tests when ctest starts, not after each link: a build stays a build.
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60 NO_PRETTY_VALUES TEST_PREFIX ${name}. PROPERTIES ${properties})
  if(NOT arg_EACH)
    add_whole_test(${name} "${arg_SHARDS}" ${properties})
  endif()
endfunction()

# Puts the program as a whole in place of the list of its tests, which was added last, unless each is asked for.
function(add_whole_test name shards)
  get_property(lists DIRECTORY PROPERTY TEST_INCLUDE_FILES)
  list(POP_BACK lists each)
  set(whole ${CMAKE_CURRENT_BINARY_DIR}/${name}_whole.cmake)
  set_property(DIRECTORY PROPERTY TEST_INCLUDE_FILES ${lists} ${whole})

  get_property(command TARGET ${name} PROPERTY CROSSCOMPILING_EMULATOR)
  list(APPEND command $<TARGET_FILE:${name}>)
  list(JOIN command "]==] [==[" words)
  list(JOIN ARGN "]==] [==[" values)
  if(NOT shards)
    set(shards 1)
  endif()
  set(tests "")
  foreach(shard RANGE 1 ${shards})
    math(EXPR index "${shard} - 1")
    if(shards EQUAL 1)
      set(test ${name})
    else()
      set(test ${name}.${shard}_of_${shards})
    endif()
    string(APPEND tests
      "  add_test([==[${test}]==] [==[${words}]==])\n"
      "  set_tests_properties([==[${test}]==] PROPERTIES [==[${values}]==]\n"
      "    ENVIRONMENT [==[GTEST_TOTAL_SHARDS=${shards};GTEST_SHARD_INDEX=${index}]==]\n"
      "    WORKING_DIRECTORY [==[${CMAKE_CURRENT_BINARY_DIR}]==])\n")
  endforeach()
  file(GENERATE OUTPUT ${whole} CONTENT
    "if(DEFINED ENV{GHOSTFORCE_TEST_BY_TEST})\n  include([==[${each}]==])\nelse()\n${tests}endif()\n")
endfunction()

# Reports that are not ours to fix are kept out however ctest is started; the tests inherit its environment.
configure_file(${PROJECT_SOURCE_DIR}/cmake/sanitizer_environment.cmake.in
  ${PROJECT_BINARY_DIR}/sanitizer_environment.cmake @ONLY)
set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY
  TEST_INCLUDE_FILES ${PROJECT_BINARY_DIR}/sanitizer_environment.cmake)
