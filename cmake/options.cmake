# What every target of ours is compiled with. Link isl::options privately.
#
# -ffp-contract=off: a fused multiply-add rounds once where the other targets round twice; pictures must not depend on the
# machine. -fno-math-errno and -fno-trapping-math change no value; -ffast-math is never used.
add_library(isl_options INTERFACE)
add_library(isl::options ALIAS isl_options)
target_include_directories(isl_options INTERFACE ${PROJECT_SOURCE_DIR})
target_include_directories(isl_options SYSTEM INTERFACE ${PROJECT_BINARY_DIR})  # bison's header is not ours to polish
target_compile_features(isl_options INTERFACE cxx_std_20)
target_compile_options(isl_options INTERFACE
  -ffp-contract=off -fno-math-errno -fno-trapping-math
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor -Wold-style-cast -Woverloaded-virtual
  # GCC 12 reports std::string's own copies as out of bounds (GCC's bugs 105329 and 105651).
  "$<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-array-bounds;-Wno-restrict;-Wno-stringop-overflow;-Wno-stringop-overread>"
  $<$<BOOL:${ISL_WERROR}>:-Werror>)

# Libraries of which only headers are used need not be loaded.
target_link_options(isl_options INTERFACE LINKER:--as-needed)

include(${CMAKE_CURRENT_LIST_DIR}/vector_widths.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/hardening.cmake)
if(ISL_HARDENING)
  isl_harden(isl_options)
endif()
