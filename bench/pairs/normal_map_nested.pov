// An entry of a map has a map of its own.
#include "stage.inc"
#declare Inner = normal { gradient x normal_map { [0.3 bumps 0.6 scale 0.1] [0.7 wrinkles 0.8 scale 0.3] } }
Bumpy(normal { gradient y normal_map { [0.3 Inner] [0.7 ripples 0.5 frequency 5] } rotate 20*z })
