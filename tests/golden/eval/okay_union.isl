// Children keep their own textures and transforms; a light may be one.
#declare Part = union {
  sphere { 0, 1 pigment { rgb x } translate x }
  light_source { <0, 1, 0>, 1 }
  rotate 90*y
}
union { Part translate y }
union { sphere { 0, 1 } object { Part scale 2 } no_shadow pigment { rgb y } }
