// Similarities are baked into a component; any other transform stays beside it. Equal textures are one.
#declare Skin = texture { pigment { rgb x } }
blob {
  sphere { x, 1, 1 texture { Skin } rotate 90*z }
  cylinder { 0, x, 1, 1 pigment { rgb x } scale 2 translate y }
  sphere { x, 1, 1 pigment { rgb z } scale <1, 2, 1> }
  pigment { rgb y }
  translate 3*z
}
