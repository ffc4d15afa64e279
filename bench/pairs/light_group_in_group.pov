// A group within a group.
#include "stage.inc"
View() Floor()
light_source { <3, 6, -4> rgb 0.5 }
#declare Inner = union { sphere { <1.2, 0.7, 0>, 0.7 } cylinder { <2.4, 0, 0>, <2.4, 2, 0>, 0.4 } pigment { rgb <0.9, 0.9, 1> } }
#declare Outer = sphere { <-1, 1, 0>, 1 pigment { rgb <1, 0.8, 0.7> } }
#ifdef (Without) object { Inner } object { Outer } #else
light_group {
  light_source { <-4, 4, -4> rgb <1, 0.5, 0.2> }
  object { Outer }
  light_group { light_source { <0, 5, -3> rgb <0.2, 0.5, 1> } object { Inner } }
}
#end
