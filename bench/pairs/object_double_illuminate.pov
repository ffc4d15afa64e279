// Discs are lit from behind as from in front.
#include "stage.inc"
View() Sun() Floor()
#declare Leaves = union {
  disc { <-2, 1, -1>, <0.5, 0.3, 1>, 0.9 }
  disc { <0.3, 1.2, 0>, <0.3, 1, 0.8>, 1 }
  disc { <-1.6, 2, 1>, <1, -0.4, 0.3>, 1 }
}
object { Leaves pigment { rgb <0.3, 0.8, 0.4> } #ifndef (Without) double_illuminate #end }
