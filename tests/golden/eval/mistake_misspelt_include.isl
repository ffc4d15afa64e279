#include "shapez.inc"
sphere { 0, 1 }
