// Included by a file that Highway's foreach_target compiles for every vector width, once for each, before the inner loops
// themselves; hence no `#pragma once`. The fallback without vectors is for machines that hardly exist: eight numbers one by one
// are much code, and full optimising took the compiler four times as long as without, more than all other widths together.
// It comes last, so that nothing else is compiled this way. No value changes: the operations are the same.
#if HWY_TARGET == HWY_SCALAR && defined(__GNUC__) && !defined(__clang__) && defined(__OPTIMIZE__)
#pragma GCC optimize("O1")
#endif
