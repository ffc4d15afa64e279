// A plane of bumps that is wrapped about a sphere.
#include "stage.inc"
Bumpy(normal { quilted 0.8 scale 0.13 warp { spherical } translate y })
