// Unions inside a blob are maxima: of components, parts and unions, side by side and inside one another.
blob {
  kernel "quartic"
  sphere { 0, 1 }
  union {
    sphere { x, 0.5 }
    blob { sphere { y, 0.5 } union { sphere { 2 * y, 0.25 } sphere { 3 * y, 0.25 } } }
    union { sphere { z, 0.5 } cylinder { z, 2 * z, 0.25 } translate z }
    pigment { rgb <0, 1, 0> }
  }
  union { sphere { -x, 0.5 } blob { sphere { -y, 0.5 } } }
}
