# The manual pages, and what completes the command line in bash, zsh and fish: the program prints them itself
# (ghostforce help --format …). The target all writes them to share/ of the build tree, as an installation has them.
#
# They are installed where they have been made: ./demo builds the program alone, and that can be installed too.
# A package whose shells look elsewhere sets GHOSTFORCE_INSTALL_ZSHDIR: Debian's is share/zsh/vendor-completions.

set(GHOSTFORCE_INSTALL_ZSHDIR ${CMAKE_INSTALL_DATADIR}/zsh/site-functions CACHE STRING
  "Where zsh's completion is installed, below the prefix")

# Another machine's program cannot print them here.
if(CMAKE_CROSSCOMPILING AND NOT CMAKE_CROSSCOMPILING_EMULATOR)
  return()
endif()

set(manual_folder ${PROJECT_BINARY_DIR}/share)
set(manual_files "")

# manual_file(PATH DESTINATION ARGUMENTS...): what `ghostforce help ARGUMENTS` prints, below share/ and installed there.
function(manual_file path destination)
  set(file ${manual_folder}/${path})
  cmake_path(GET file PARENT_PATH folder)
  add_custom_command(
    OUTPUT ${file}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${folder}
    COMMAND ghostforce help ${ARGN} > ${file}
    DEPENDS ghostforce
    COMMENT "Writing share/${path}"
    VERBATIM)
  install(FILES ${file} DESTINATION ${destination} OPTIONAL)
  set(manual_files ${manual_files} ${file} PARENT_SCOPE)
endfunction()

# One page for each row of the catalog.
set(command_catalog ${PROJECT_SOURCE_DIR}/app/cli/command_catalog.cpp)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${command_catalog})
file(STRINGS ${command_catalog} rows REGEX "^ +Command{\"")
if(NOT rows)
  message(FATAL_ERROR "No row of a command was found in ${command_catalog}.")
endif()
manual_file(man/man1/ghostforce.1 ${CMAKE_INSTALL_MANDIR}/man1 --format man)
foreach(row IN LISTS rows)
  string(REGEX REPLACE "^ +Command{\"([^\"]+)\".*" "\\1" command "${row}")
  manual_file(man/man1/ghostforce-${command}.1 ${CMAKE_INSTALL_MANDIR}/man1 --format man ${command})
endforeach()

manual_file(bash-completion/completions/ghostforce ${CMAKE_INSTALL_DATADIR}/bash-completion/completions --format bash)
manual_file(zsh/site-functions/_ghostforce ${GHOSTFORCE_INSTALL_ZSHDIR} --format zsh)
manual_file(fish/vendor_completions.d/ghostforce.fish ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d --format fish)

add_custom_target(manual ALL DEPENDS ${manual_files})
