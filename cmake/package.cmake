# What ./package makes of an installed tree, besides what resources.cmake installs anywhere: the list of what the program
# is made of, and the Debian package, by CPack.

# ---- What it is made of: share/doc/ghostforce/ghostforce.cdx.json ----------------------------------------------------

set(sbom ${PROJECT_BINARY_DIR}/ghostforce.cdx.json)
set(sbom_options
  --version=${PROJECT_VERSION} --notices=${PROJECT_SOURCE_DIR}/THIRD_PARTY_NOTICES.md
  --architecture=${CMAKE_LIBRARY_ARCHITECTURE})
if(imgui_wheel_dir)
  list(APPEND sbom_options
    --wheel=${PROJECT_SOURCE_DIR}/cmake/imgui-wheel-requirements.txt --headers=${imgui_wheel_dir}/include)
endif()
list(JOIN sbom_options "\n" sbom_options)
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/sbom-options.txt CONTENT "${sbom_options}\n" @ONLY)
add_custom_command(
  OUTPUT ${sbom}
  COMMAND ${GHOSTFORCE_PYTHON} -B ${PROJECT_SOURCE_DIR}/cmake/package/sbom.py @${PROJECT_BINARY_DIR}/sbom-options.txt
          $<TARGET_FILE:ghostforce> > ${sbom}
  DEPENDS
    ghostforce ${PROJECT_BINARY_DIR}/sbom-options.txt ${PROJECT_SOURCE_DIR}/cmake/package/sbom.py
    ${PROJECT_SOURCE_DIR}/cmake/package/notices.py ${PROJECT_SOURCE_DIR}/THIRD_PARTY_NOTICES.md
  COMMENT "Listing what the program is made of"
  VERBATIM)
add_custom_target(sbom ALL DEPENDS ${sbom})
# ./demo builds the program alone, and what it has built can be installed too.
install(FILES ${sbom} DESTINATION ${CMAKE_INSTALL_DOCDIR} OPTIONAL)

# ---- The Debian package ----------------------------------------------------------------------------------------------

# packages_of(SECTION OUT): the packages of a section of packages.txt.
function(packages_of section out)
  file(STRINGS ${PROJECT_SOURCE_DIR}/packages.txt lines REGEX "^[^#]")
  set(packages "")
  set(here "")
  foreach(line IN LISTS lines)
    if(line MATCHES "^.(.+)]$")
      set(here ${CMAKE_MATCH_1})
    elseif(here STREQUAL section)
      list(APPEND packages ${line})
    endif()
  endforeach()
  list(TRANSFORM packages REPLACE " optional$" "")
  set(${out} ${packages} PARENT_SCOPE)
endfunction()

set(GHOSTFORCE_MAINTAINER "" CACHE STRING "Who answers for the Debian package: Name <address>; ./package says it")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME ghostforce)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_STRIP_FILES ON)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER ${GHOSTFORCE_MAINTAINER})
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "shows, simulates and measures ghost forces of haptic devices")
set(CPACK_PACKAGE_DESCRIPTION
"Many haptic devices sense motion in more directions than they can push in.
Press such a device against a virtual wall, and ordinary rendering produces a
ghost force: it drags the hand along the wall, away from where it wants to be.

ghostforce shows this live, in pictures and in exact numbers, next to the cure,
an anisotropic tracking stiffness. It has lessons for teaching, a workbench for
experiments, and commands for simulations, figures and comparison of pictures.
A mouse is enough; a Novint Falcon and a SpaceMouse can be used too.")

# What the linker asked for, by the package's own name and version; what is opened while the program runs; and the font.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
packages_of(run opened)
# Those without which a window opens and pictures are drawn all the same.
set(recommended ${opened})
list(FILTER recommended INCLUDE REGEX "^lib(osmesa|decor|systemd)")
list(REMOVE_ITEM opened ${recommended})
list(APPEND recommended wl-clipboard)
list(JOIN recommended ", " CPACK_DEBIAN_PACKAGE_RECOMMENDS)
list(JOIN opened ", " CPACK_DEBIAN_PACKAGE_DEPENDS)
string(PREPEND CPACK_DEBIAN_PACKAGE_DEPENDS "fonts-dejavu-core, ")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "ffmpeg, speech-dispatcher")

set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/cmake/package/postinst)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/package/debian_tree.cmake)
# For that script.
set(CPACK_GHOSTFORCE_SOURCE_DIR ${PROJECT_SOURCE_DIR})
set(CPACK_GHOSTFORCE_PYTHON ${GHOSTFORCE_PYTHON})

set(CPACK_VERBATIM_VARIABLES ON)
include(CPack)
