# Compiles a target's files in batches, each as one unit: a file on its own spends most of its time on headers and templates that its
# neighbours need too. Included after all targets; the other CMakeLists.txt know nothing of it.
#
# Files of a target share a unit, so their unnamed namespaces are one: names in them are distinct within a target. A file may then lack
# an include that a neighbour has; ISL_UNITY=OFF shows it, and ./isl style compiles files alone.
option(ISL_UNITY "Compile files in batches" ON)

# Larger batches save less and less, and leave cores idle at the end.
set(isl_batch 12)

# Even batches: of 13 files two of 7 and 6 instead of one of 12 and one alone.
function(isl_compile_in_batches target)
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources INCLUDE REGEX "\\.cpp$")
  list(LENGTH sources count)
  math(EXPR batches "(${count} + ${isl_batch} - 1) / ${isl_batch}")
  if(batches GREATER 0)
    math(EXPR size "(${count} + ${batches} - 1) / ${batches}")
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${size})
  endif()
endfunction()

function(isl_compile_folder_in_batches folder)
  get_property(targets DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
  foreach(target IN LISTS targets)
    get_target_property(type ${target} TYPE)
    if(type MATCHES "^(STATIC_LIBRARY|EXECUTABLE)$")
      isl_compile_in_batches(${target})
    endif()
  endforeach()
  get_property(subfolders DIRECTORY ${folder} PROPERTY SUBDIRECTORIES)
  foreach(subfolder IN LISTS subfolders)
    isl_compile_folder_in_batches(${subfolder})
  endforeach()
endfunction()

if(ISL_UNITY)
  foreach(part base grammar interpreter renderer cli)
    isl_compile_folder_in_batches(${PROJECT_SOURCE_DIR}/${part})
  endforeach()
  if(ISL_TESTS)
    isl_compile_folder_in_batches(${PROJECT_SOURCE_DIR}/tests)
  endif()
endif()
