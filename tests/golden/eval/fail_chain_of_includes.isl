#include "included.inc"
Ball("wide")
