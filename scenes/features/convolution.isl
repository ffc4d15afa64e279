// Limbs that meet, as functions of the distance to the nearest point of each skeleton (above), and convolved: the kernel
// integrated along the skeletons (below). Where distance fields add up they bulge; where a convolution is cut in two, as every
// limb here is at the crossing, nothing shows. On the right rings: a wheel, whose spokes pass through its rim. Below a sheet: a
// plane without end, convolved, out of which posts and an arch grow.
camera { location <0, 1.2, -11> look_at <0, -0.6, 0> angle 48 }
light_source { <-4, 8, -8> rgb 0.9 }
light_source { <6, 2, -9> rgb 0.35 shadowless }
background { rgb <0.93, 0.94, 0.96> }

#macro Crossing()
  cylinder { <-1.3, -0.9, 0>, 0, 0.3 }
  cylinder { 0, <1.3, 0.9, 0>, 0.3 }
  cylinder { <-1.3, 0.9, 0>, 0, 0.3 }
  cylinder { 0, <1.3, -0.9, 0>, 0.3 }
#end

#macro Wheel()
  torus { 1, 0.16 rotate 90 * x }
  #for (I, 0, 5)
    cylinder { 0, 1.3 * <cos(I * pi / 3), sin(I * pi / 3), 0>, 0.14 }
  #end
#end

blob {
  kernel "quartic" hardness 3
  Crossing()
  pigment { rgb <0.85, 0.45, 0.3> } finish { specular 0.3 }
  translate <-1.7, 1.5, 0>
}
blob {
  kernel "quartic" hardness 3
  convolution on
  Crossing()
  pigment { rgb <0.35, 0.55, 0.8> } finish { specular 0.3 }
  translate <-1.7, -1.5, 0>
}
blob {
  kernel "cauchy" hardness 3
  Wheel()
  pigment { rgb <0.85, 0.45, 0.3> } finish { specular 0.3 }
  translate <1.7, 1.5, 0>
}
blob {
  kernel "cauchy" hardness 3
  convolution on
  Wheel()
  pigment { rgb <0.35, 0.55, 0.8> } finish { specular 0.3 }
  translate <1.7, -1.5, 0>
}
blob {
  kernel "cauchy" hardness 2
  convolution on
  plane { y, -3.6, 0.2 }
  #for (I, -3, 3)
    #if (I != 0) cylinder { <1.1 * I, -3.6, -1.2>, <1.1 * I, -2.8, -1.2>, 0.2 } #end
  #end
  torus { 0.5, 0.15 rotate 90 * x translate <0, -3.6, -1.2> }
  pigment { rgb <0.75, 0.7, 0.55> } finish { specular 0.2 }
}
