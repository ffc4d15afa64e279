# ISL_VECTOR_WIDTHS → the definitions by which Highway compiles the inner loops for these widths. Pictures are the same with all.
#   all      every width: for programs that are installed or run on other machines
#   machine  the widest that this machine has: what a build of one's own needs, in a third of the time
#   sse4     one: for sanitizers, whose checks multiply what each costs
# ISL_ONE_WIDTH_DEFINITIONS is empty with `all`. One width is made Highway's baseline; its own baseline on x86 has one lane, which
# takes the compiler longer than four registers of two.
set(ISL_VECTOR_WIDTHS all CACHE STRING "Vector widths that the inner loops are compiled for: all, machine or sse4")
set_property(CACHE ISL_VECTOR_WIDTHS PROPERTY STRINGS all machine sse4)

set(isl_widths SSE4 AVX2 AVX3)

# The widest of isl_widths that this machine has; empty where it has none.
function(isl_find_widest_vectors result)
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/widest_vectors.cpp CONTENT [=[
#include <hwy/targets.h>
#include <cstdio>
int main() {
  const auto has = hwy::SupportedTargets();
  std::fputs(has & HWY_AVX3 ? "AVX3" : has & HWY_AVX2 ? "AVX2" : has & HWY_SSE4 ? "SSE4" : "", stdout);
}
]=])
  try_run(exit_code is_built ${PROJECT_BINARY_DIR}/widest_vectors ${PROJECT_BINARY_DIR}/widest_vectors.cpp
          LINK_LIBRARIES hwy::hwy RUN_OUTPUT_VARIABLE widest)
  if(is_built AND exit_code EQUAL 0)
    set(${result} ${widest} PARENT_SCOPE)
  endif()
endfunction()

set(isl_width)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  if(ISL_VECTOR_WIDTHS STREQUAL "machine")
    isl_find_widest_vectors(isl_width)
  elseif(ISL_VECTOR_WIDTHS STREQUAL "sse4")
    set(isl_width SSE4)
  endif()
endif()

if(isl_width)
  set(isl_others ${isl_widths})
  list(REMOVE_ITEM isl_others ${isl_width})
  list(TRANSFORM isl_others PREPEND HWY_)
  list(JOIN isl_others "|" isl_others)
  set(ISL_ONE_WIDTH_DEFINITIONS
    "HWY_BASELINE_TARGETS=(HWY_${isl_width}|HWY_SCALAR)" "HWY_DISABLED_TARGETS=(HWY_SSSE3|HWY_AVX3_DL|${isl_others})")
  set(ISL_VECTOR_WIDTH_DEFINITIONS ${ISL_ONE_WIDTH_DEFINITIONS})
else()
  # SSSE3 and AVX3_DL add nothing over SSE2's and AVX3's loops, and each width costs build time.
  set(ISL_VECTOR_WIDTH_DEFINITIONS "HWY_DISABLED_TARGETS=(HWY_SSSE3|HWY_AVX3_DL)")
endif()
