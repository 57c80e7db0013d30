# cmake -D BUILD_DIR=directory -P install_test.cmake
# The installed tree works by itself: its program starts, and finds its fonts, from a directory that has nothing in it.
# What other programs look for there is there.

set(scratch ${BUILD_DIR}/install_test)
file(REMOVE_RECURSE ${scratch})
file(MAKE_DIRECTORY ${scratch}/elsewhere)

function(run)
  execute_process(COMMAND ${ARGV} WORKING_DIRECTORY ${scratch}/elsewhere COMMAND_ERROR_IS_FATAL ANY)
endfunction()

run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${scratch}/prefix)
# Renamed once installed: a path that was compiled in would no longer hold.
file(RENAME ${scratch}/prefix ${scratch}/moved)
if(NOT EXISTS ${scratch}/moved/lib/udev/rules.d/70-ghostforce.rules)
  message(FATAL_ERROR "The rules that let people use their devices were not installed.")
endif()
if(NOT EXISTS ${scratch}/moved/libexec/ghostforce/ghostforce-guard)
  message(FATAL_ERROR "The guard of the motors was not installed.")
endif()
foreach(file IN ITEMS
    applications/ghostforce.desktop
    bash-completion/completions/ghostforce
    doc/ghostforce/LICENSE
    doc/ghostforce/README.md
    doc/ghostforce/THIRD_PARTY_NOTICES.md
    doc/ghostforce/docs/falcon.md
    doc/ghostforce/ghostforce.cdx.json
    fish/vendor_completions.d/ghostforce.fish
    ghostforce/lessons/ghost.toml
    ghostforce/scenes/wall45.toml
    icons/hicolor/scalable/apps/ghostforce.svg
    man/man1/ghostforce-render.1
    man/man1/ghostforce.1
    metainfo/org.ghostforce.ghostforce.metainfo.xml
    mime/packages/ghostforce.xml)
  if(NOT EXISTS ${scratch}/moved/share/${file})
    message(FATAL_ERROR "share/${file} was not installed.")
  endif()
endforeach()
run(${scratch}/moved/bin/ghostforce --version)
run(${scratch}/moved/bin/ghostforce render wall45 --size 640x400 -o picture.png)
run(${BUILD_DIR}/bin/ghostforce render wall45 --size 640x400 -o expected.png)
run(${CMAKE_COMMAND} -E compare_files picture.png expected.png)
