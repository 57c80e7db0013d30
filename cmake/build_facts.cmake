# How the desktop program was built, for `ghostforce --version`: <ghostforce_build.h>.

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

set(build_type ${CMAKE_BUILD_TYPE})
if(GHOSTFORCE_SANITIZE)
  string(APPEND build_type " with sanitizers: ${GHOSTFORCE_SANITIZE}")
endif()
list(TRANSFORM GHOSTFORCE_LIBRARIES REPLACE "[|].*" "" OUTPUT_VARIABLE library_words)
list(JOIN library_words ", " library_words)
configure_file(${PROJECT_SOURCE_DIR}/cmake/ghostforce_build.h.in ${PROJECT_BINARY_DIR}/generated/ghostforce_build.h)
