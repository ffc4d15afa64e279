// Files that Highway's foreach_target compiles once for every vector width include this one before the inner loops
// themselves; hence it has no `#pragma once`. The fallback without vectors serves machines that hardly exist: handling
// eight numbers one by one is much code, and optimising it fully took the compiler four times as long as not optimising
// it, more than all other widths together. The fallback comes last, so that nothing else is compiled this way. No value
// changes, because the operations are the same.
#if HWY_TARGET == HWY_SCALAR && defined(__GNUC__) && !defined(__clang__) && defined(__OPTIMIZE__)
#pragma GCC optimize("O1")
#endif
