# Run by CPack on the installed tree: what a Debian package has elsewhere, in another form, or from another package.
set(share ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/usr/share)
set(doc ${share}/doc/ghostforce)
set(python ${CPACK_GHOSTFORCE_PYTHON} -B)
set(here ${CPACK_GHOSTFORCE_SOURCE_DIR}/cmake/package)

# The fonts are those of fonts-dejavu-core.
file(REMOVE_RECURSE ${share}/ghostforce/fonts)
file(CREATE_LINK ../fonts/truetype/dejavu ${share}/ghostforce/fonts SYMBOLIC)

# The licences are in one file, of a form that programs read.
execute_process(
  COMMAND ${python} ${here}/copyright.py ${doc}/LICENSE ${doc}/THIRD_PARTY_NOTICES.md
  OUTPUT_FILE ${doc}/copyright COMMAND_ERROR_IS_FATAL ANY)
file(REMOVE ${doc}/LICENSE ${doc}/THIRD_PARTY_NOTICES.md)
file(READ ${doc}/README.md text)
string(REGEX REPLACE "\\]\\((LICENSE|THIRD_PARTY_NOTICES\\.md)\\)" "](copyright)" text "${text}")
file(WRITE ${doc}/README.md "${text}")

execute_process(
  COMMAND ${python} ${here}/changelog.py ${CPACK_GHOSTFORCE_SOURCE_DIR}/CHANGELOG.md ${CPACK_DEBIAN_PACKAGE_MAINTAINER}
  OUTPUT_FILE ${doc}/changelog COMMAND_ERROR_IS_FATAL ANY)

# zsh looks for what packages bring in a folder of its own.
if(EXISTS ${share}/zsh/site-functions)
  file(RENAME ${share}/zsh/site-functions ${share}/zsh/vendor-completions)
endif()

file(GLOB_RECURSE long ${share}/man/*.[0-9] ${doc}/changelog)
execute_process(COMMAND gzip -9n ${long} COMMAND_ERROR_IS_FATAL ANY)
