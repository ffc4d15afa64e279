blob {
  kernel "quartic" hardness 3
  cylinder { 0, 2 * x, 0.5 }
  convolution on
  cylinder { 0, 2 * y, 0.5 strength 2 scale <1, 2, 1> }
  kernel "cauchy"
  torus { 2, 0.5 }
  plane { 2 * y, -3, 0.5 }          // a sheet, with a kernel of its own
  torus { 2, 0.5 }
  cylinder { 0, 0, 0.5 }            // of no length: it adds nothing
  convolution off
  torus { 2, 0.5 }
  plane { y, -3, 0.5 }              // a half-space
  threshold 0.7
}
blob { convolution on kernel "quartic" cylinder { 0, z, 0.1 } }
#declare convolution = 3;
blob { kernel "quartic" cylinder { 0, convolution * z, 0.1 } }
