# ghostforce_add_test(name SOURCES file... [SUPPORT name...] [LIBRARIES target...] [LABELS label] [LAUNCHER command...]
#                     [SERIAL])
#
# One GoogleTest program; each of its tests becomes one of ctest, named program.Suite.test. SUPPORT: files of
# tests/support without their ending; `program` also builds ghostforce and says where it is. The label `tsan` marks a
# program in which threads meet: CI runs it under the thread sanitizer too. SERIAL: nothing else runs beside its tests.

include(GoogleTest)

add_custom_target(tsan_tests COMMENT "The tests labelled tsan, without building the others")

function(ghostforce_add_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "SERIAL" "LABELS" "SOURCES;SUPPORT;LIBRARIES;LAUNCHER")
  if(NOT arg_SOURCES OR arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "ghostforce_add_test(${name}): want SOURCES; got \"${ARGV}\"")
  endif()
  list(TRANSFORM arg_SUPPORT REPLACE "(.+)" "${PROJECT_SOURCE_DIR}/tests/support/\\1.cpp" OUTPUT_VARIABLE support)
  add_executable(${name} ${arg_SOURCES} ${support})
  target_link_libraries(${name} PRIVATE ${arg_LIBRARIES} GTest::gtest_main project_options project_warnings)
  target_compile_definitions(${name} PRIVATE GHOSTFORCE_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  if(program IN_LIST arg_SUPPORT)
    target_compile_definitions(${name} PRIVATE GHOSTFORCE_PROGRAM="$<TARGET_FILE:ghostforce>")
    add_dependencies(${name} ghostforce)
  endif()
  if(arg_LAUNCHER)
    # CMake's name for it, from the days when only another machine's programs had one.
    set_property(TARGET ${name} PROPERTY CROSSCOMPILING_EMULATOR ${arg_LAUNCHER})
  endif()
  # PRE_TEST lists the tests when ctest starts, not after each link: a build stays a build.
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60 TEST_PREFIX ${name}.
    PROPERTIES TIMEOUT 300 RUN_SERIAL "${arg_SERIAL}" LABELS "${arg_LABELS}")
  if(arg_LABELS STREQUAL "tsan")
    add_dependencies(tsan_tests ${name})
  endif()
endfunction()

# Reports that are not ours to fix are kept out however ctest is started; the tests inherit its environment.
configure_file(${PROJECT_SOURCE_DIR}/cmake/sanitizer_environment.cmake.in
  ${PROJECT_BINARY_DIR}/sanitizer_environment.cmake @ONLY)
set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY
  TEST_INCLUDE_FILES ${PROJECT_BINARY_DIR}/sanitizer_environment.cmake)
