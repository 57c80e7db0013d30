# What the program carries besides its code: its version, its fonts, its scenes and its licences.
#
#   ghostforce::resources   <ghostforce_version.h>   ghostforce::version
#                           <ghostforce_paths.h>     ghostforce::font_directories
#
# Paths in the header are relative to the directory of the executable, so that build trees, installed trees and copies
# of either all work.
include(GNUInstallDirs)

configure_file(${PROJECT_SOURCE_DIR}/cmake/ghostforce_version.h.in ${PROJECT_BINARY_DIR}/generated/ghostforce_version.h)

set(GHOSTFORCE_INSTALL_DATADIR ${CMAKE_INSTALL_DATADIR}/ghostforce)
file(RELATIVE_PATH GHOSTFORCE_DATADIR_FROM_BINDIR
  ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_DATADIR}/ghostforce)
configure_file(${PROJECT_SOURCE_DIR}/cmake/ghostforce_paths.h.in ${PROJECT_BINARY_DIR}/generated/ghostforce_paths.h)

add_library(ghostforce_resources INTERFACE)
target_include_directories(ghostforce_resources INTERFACE ${PROJECT_BINARY_DIR}/generated)
add_library(ghostforce::resources ALIAS ghostforce_resources)

# The page carries all of this in itself.
if(EMSCRIPTEN)
  return()
endif()

foreach(font IN LISTS GHOSTFORCE_FONTS)
  file(COPY ${font} DESTINATION ${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/fonts)
endforeach()

install(FILES ${GHOSTFORCE_FONTS} DESTINATION ${GHOSTFORCE_INSTALL_DATADIR}/fonts)
# Scenes and lessons are embedded in the program; these copies are for people to start their own from.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/assets/scenes ${PROJECT_SOURCE_DIR}/assets/lessons DESTINATION ${GHOSTFORCE_INSTALL_DATADIR}
  FILES_MATCHING PATTERN *.toml)
# What a desktop wants to know: the entry of its menu, the icon, the words of its software centre, and which files a
# double click opens.
set(desktop ${PROJECT_SOURCE_DIR}/assets/desktop)
install(FILES ${desktop}/ghostforce.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
install(FILES ${desktop}/ghostforce.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
install(FILES ${desktop}/org.ghostforce.ghostforce.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo)
install(FILES ${desktop}/ghostforce-mime.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages RENAME ghostforce.xml)
foreach(page LICENSE THIRD_PARTY_NOTICES.md README.md ARCHITECTURE.md CONTRIBUTING.md)
  install(FILES ${PROJECT_SOURCE_DIR}/${page} DESTINATION ${CMAKE_INSTALL_DOCDIR})
endforeach()
# The guides that messages of the program name, as in docs/falcon.md.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs DESTINATION ${CMAKE_INSTALL_DOCDIR})
