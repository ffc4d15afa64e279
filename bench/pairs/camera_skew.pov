// The picture's axes are not at right angles, and its middle lies aside.
#include "stage.inc"
Seen(camera { location <1, 2, -6> direction <0.2, -0.1, 1.2> right <1.3, 0.2, 0.1> up <0.1, 1, 0.2> })
