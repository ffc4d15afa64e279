# Hardening as Debian's packages have it: position-independent programs, relocations that are read-only before main() begins, guards
# for stacks and for the C library's buffers. The price stands in docs/decisions.md, and so does the reason why the C++ library's checks
# of its preconditions (_GLIBCXX_ASSERTIONS) are on in the builds that look for mistakes, and in tests, but not in what users run.
option(ISL_HARDENING "Hardened programs, in release builds" ON)

add_compile_definitions($<$<CONFIG:Debug>:_GLIBCXX_ASSERTIONS>)

function(isl_harden target)
  # -fPIE and not -fPIC for libraries, too: they end in programs, where a function of ours is never replaced by another's.
  set(type $<TARGET_PROPERTY:TYPE>)
  target_compile_options(${target} INTERFACE
    $<$<NOT:$<STREQUAL:${type},MODULE_LIBRARY>>:-fPIE> $<$<CONFIG:Release>:-fstack-protector-strong>)
  target_compile_definitions(${target} INTERFACE $<$<CONFIG:Release>:_FORTIFY_SOURCE=2>)
  target_link_options(${target} INTERFACE $<$<STREQUAL:${type},EXECUTABLE>:-pie> LINKER:-z,relro LINKER:-z,now)
endfunction()

# isl_without_stack_guards(FILE…): what runs for every ray, cell or component of a blob. These files keep no buffers of text, and what they index
# is checked by the tests with assertions on. A precompiled header goes with the guards it was compiled with.
function(isl_without_stack_guards)
  if(ISL_HARDENING)
    set_source_files_properties(${ARGN} PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
    set_property(SOURCE ${ARGN} APPEND PROPERTY COMPILE_OPTIONS -fno-stack-protector)
  endif()
endfunction()

option(ISL_SANITIZED_LOOPS "The tracer's inner loops have the sanitizers of the build" ON)

# isl_inner_loops(FILE…): one large function a vector width.
function(isl_inner_loops)
  set_source_files_properties(${ARGN} PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
  # Following the variables of such a function for a debugger takes the compiler longer than all else.
  set_property(SOURCE ${ARGN} APPEND PROPERTY COMPILE_OPTIONS -fno-var-tracking)
  isl_without_stack_guards(${ARGN})
  if(NOT ISL_SANITIZED_LOOPS)
    set_property(SOURCE ${ARGN} APPEND PROPERTY COMPILE_OPTIONS -fno-sanitize=all)
  endif()
endfunction()
