# embed_text_files(TARGET target HEADER name.h FILES file...)
#
# Compiles text files into `target`, so that the program runs from any directory. Gives `target`, and whoever links it,
# a header with one table, named after the header, in the order of FILES:
#
#   #include "embedded_shaders.h"        // HEADER embedded_shaders.h
#   for (const EmbeddedText& text : ghostforce::embedded_shaders) use(text.name, text.contents);
#
# `name` is the file's name without its directory. Contents are followed by a zero byte, for interfaces that take a C
# string. A changed file rebuilds one object and nothing else.

set(embed_script ${CMAKE_CURRENT_LIST_DIR}/embed_script.cmake)

function(embed_text_files)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "TARGET;HEADER" "FILES")
  if(NOT arg_TARGET OR NOT arg_HEADER OR NOT arg_FILES OR arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "embed_text_files: want TARGET, HEADER and FILES; got \"${ARGV}\"")
  endif()
  cmake_path(GET arg_HEADER STEM table)
  set(files ${arg_FILES})
  list(TRANSFORM files PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/ REGEX "^[^/]")

  set(directory ${PROJECT_BINARY_DIR}/generated/embedded)
  set(header ${directory}/${arg_HEADER})
  set(source ${directory}/${table}.cpp)
  set(EMBEDDED_TABLE ${table})
  configure_file(${PROJECT_SOURCE_DIR}/cmake/embedded_text.h.in ${directory}/embedded_text.h COPYONLY)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/embedded_table.h.in ${header} @ONLY)
  add_custom_command(
    OUTPUT ${source}
    COMMAND ${CMAKE_COMMAND} -D TABLE=${table} -D OUTPUT=${source} -P ${embed_script} -- ${files}
    DEPENDS ${files} ${embed_script}
    COMMENT "Embedding ${table}"
    VERBATIM)
  target_sources(${arg_TARGET} PRIVATE ${source} ${header})
  target_include_directories(${arg_TARGET} PUBLIC ${directory})
endfunction()
