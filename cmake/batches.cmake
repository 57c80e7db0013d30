# ghostforce_batches(RESULT NAME SIZE file...)
#
# What a target NAME compiles of these sources. With GHOSTFORCE_BATCHES it is files that include up to SIZE sources each,
# so that headers are read once for all of them: less than half the processor time. Names must then differ within a batch,
# in unnamed namespaces too. The preset clang sees that each source can be compiled by itself, and dev is the quicker one
# after a change of one source. A source with COMPILE_OPTIONS of its own, or with the property ALONE, is in no batch; say
# so before the call.
#
# CMake's own UNITY_BUILD names sources by absolute paths, so that ccache finds nothing again in another folder.

option(GHOSTFORCE_BATCHES "Compile sources in batches" OFF)

function(ghostforce_batches result name size)
  set(sources ${ARGN})
  set(compiled "")
  if(GHOSTFORCE_BATCHES)
    foreach(source IN LISTS ARGN)
      get_property(alone SOURCE ${source} PROPERTY ALONE)
      get_property(options SOURCE ${source} PROPERTY COMPILE_OPTIONS)
      if(alone OR options)
        list(REMOVE_ITEM sources ${source})
        list(APPEND compiled ${source})
      endif()
    endforeach()
    while(sources)
      list(SUBLIST sources 0 ${size} batch)
      list(REMOVE_ITEM sources ${batch})
      list(LENGTH compiled number)
      set(file ${CMAKE_CURRENT_BINARY_DIR}/${name}_${number}.cpp)
      set(includes "")
      foreach(source IN LISTS batch)
        cmake_path(ABSOLUTE_PATH source NORMALIZE)
        cmake_path(RELATIVE_PATH source BASE_DIRECTORY ${PROJECT_SOURCE_DIR})
        string(APPEND includes "#include \"${source}\"\n")
      endforeach()
      file(CONFIGURE OUTPUT ${file} CONTENT "${includes}" @ONLY)
      list(APPEND compiled ${file})
    endwhile()
  else()
    set(compiled ${sources})
  endif()
  set(${result} ${compiled} PARENT_SCOPE)
endfunction()

# In a batch a name of one source seems to be shadowed in the next, and g++ takes sources for headers. Where each is
# compiled by itself, clang warns of what is shadowed.
add_library(batch_warnings INTERFACE)
if(GHOSTFORCE_BATCHES)
  target_compile_options(batch_warnings INTERFACE -Wno-shadow $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
endif()
