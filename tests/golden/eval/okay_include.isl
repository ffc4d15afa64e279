// Locals of an included file end with it; a macro of an included file is found.
#include "included.inc"
#debug concat(str(FromInclude, 0, 0), " ", str(defined(OnlyThere), 0, 0), "\n")
Ball(2)
