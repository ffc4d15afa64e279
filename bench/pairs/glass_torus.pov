// Light enters a ring more than once.
#include "stage.inc"
Clear(torus { 1, 0.4 rotate 60*x translate y }, Glass)
