#include "fail_include_of_itself.isl"
