// An inverse that has lost digits is told where that happens. Scales alone lose none, however uneven.
blob {
  sphere { 0, 1, 1 scale <1e6, 1, 1e-6> }
  sphere { 0, 1, 1 scale <1e6, 1, 1e-6> rotate 30*y translate x }
  sphere { 0, 1, 1 rotate 30*y scale <1e6, 1, 1e-6> }
  sphere { 0, 1, 1 scale <10, 1, 0.1> rotate 30*y }
}
sphere { 0, 1 matrix <1, 0.3, 0.7, 0.1, 1, 0.2, 1.1, 1.3, 0.90000000001, 0, 0, 0> }
union { sphere { 0, 1 } box { -1, 1 } scale <1, 1e14, 1> }
union { sphere { 0, 1 } box { -1, 1 } scale <1e6, 1, 1e-6> rotate 10*z rotate 1*y }
