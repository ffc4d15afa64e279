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
  $<$<BOOL:${ISL_WERROR}>:-Werror>)

# With one vector width: what makes it Highway's baseline. Its own on x86 is one lane, which takes the compiler longer than four
# registers of two.
if(ISL_ONE_VECTOR_WIDTH AND CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  set(ISL_ONE_WIDTH_DEFINITIONS
    "HWY_BASELINE_TARGETS=(HWY_SSE4|HWY_SCALAR)" "HWY_DISABLED_TARGETS=(HWY_SSSE3|HWY_AVX2|HWY_AVX3|HWY_AVX3_DL)")
endif()
