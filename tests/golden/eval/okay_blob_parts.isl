// Parts of a blob: their transforms, textures and thresholds, the kernel in force, copies.
#declare Limb = blob { threshold 2 kernel "quartic" sphere { x, 0.5 strength 4 } pigment { rgb 0.5 } scale 2 }
blob {
  threshold 0.5
  kernel "gaussian" hardness 6
  sphere { 0, 1 }
  blob {
    sphere { x, 0.5 }
    kernel "soft"
    box { 0, 1, 0.2 }
    blob { plane { y, -1, 0.1 } triangle { 0, x, z, 0.1 } pigment { rgb 1 } }
    rotate 90 * z
    pigment { rgb <1, 0, 0> }
  }
  sphere { -x, 1 }
  blob { Limb translate z }
  skeleton on
}
