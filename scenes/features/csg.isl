// Combining solids and blobs: difference, intersection, merge, clipped_by, inverse.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 6.5, -11> look_at <0, 0.7, 0.3> angle 44 }
light_source { <-7, 12, -9> rgb 0.85 }
light_source { <9, 7, -6> rgb <0.25, 0.28, 0.35> }
background { rgb <0.05, 0.06, 0.09> }
#declare Shine = finish { ambient 0.12 diffuse 0.7 specular 0.5 roughness 0.02 }
#default { finish { Shine } }

plane { y, 0 pigment { rgb 0.75 } finish { ambient 0.1 diffuse 0.6 specular 0 } }

// A die: pips have their own colour, the rest that of the whole.
#macro Pip(X, Y, Z) sphere { <X, Y, Z>, 0.22 pigment { rgb <0.85, 0.1, 0.1> } } #end
difference {
  intersection { box { -1, 1 } sphere { 0, 1.38 } }
  Pip(0, 1, 0)
  Pip(-0.5, -0.5, -1) Pip(0.5, 0.5, -1)
  Pip(1, 0, 0) Pip(1, 0.5, 0.5) Pip(1, -0.5, -0.5)
  pigment { rgb <0.95, 0.93, 0.85> }
  rotate -28 * y translate <-3.4, 1, 0.6>
}

// A frame whose holes end in its own faces: no skin is left over them. POV-Ray needs a Beyond above 0 for that.
#ifndef (Beyond) #declare Beyond = 0; #end
#declare End = 1 + Beyond;
difference {
  box { -1, 1 }
  box { <-0.65, -0.65, -End>, <0.65, 0.65, End> }
  box { <-0.65, -End, -0.65>, <0.65, End, 0.65> }
  box { <-End, -0.65, -0.65>, <End, 0.65, 0.65> }
  pigment { rgb <0.2, 0.45, 0.8> }
  rotate 32 * y translate <0, 1, 1.2>
}

// A blob with its upper half taken off and a pit in the cut.
difference {
  blob {
    threshold 0.5
    sphere { <-0.6, 0.5, 0>, 1.4, 1 }
    sphere { <0.7, 0.5, 0.1>, 1.3, 1 }
    sphere { <0, 0.6, -0.7>, 1.1, 1 }
  }
  plane { -y, -0.8 pigment { rgb <0.95, 0.75, 0.4> } }
  sphere { <0, 0.9, 0>, 0.5 pigment { rgb <0.6, 0.3, 0.15> } }
  pigment { rgb <0.35, 0.6, 0.25> }
  translate <3.3, 0.02, 0.4>
}

// A shell that is clipped: no surface closes it.
difference {
  sphere { 0, 0.8 }
  sphere { 0, 0.7 inverse inverse }
  clipped_by { plane { <0.3, 1, -0.6>, 0.25 } }
  pigment { rgb <0.8, 0.4, 0.7> }
  translate <-1.7, 0.8, -1.9>
}

// Links of a chain, merged, with a hole through both.
difference {
  merge {
    torus { 0.55, 0.16 rotate 90 * x }
    torus { 0.55, 0.16 rotate 90 * z translate 0.55 * x }
  }
  cylinder { <-1, 0, 0>, <2, 0, 0>, 0.07 pigment { rgb <0.1, 0.1, 0.1> } }
  pigment { rgb <0.85, 0.65, 0.2> }
  rotate -25 * y translate <0.9, 0.71, -2>
}

// A lens, the intersection of two spheres, standing in a slot.
intersection {
  sphere { -0.85 * z, 1.1 }
  sphere { 0.85 * z, 1.1 }
  pigment { rgb <0.5, 0.8, 0.85> }
  rotate 30 * y translate <3.2, 0.68, -2.2>
}
