// Components whose geometry has collapsed have the field of what is left, with a warning; convolved, they add nothing.
#macro Generated(Length) cylinder { 0, Length * x, 0.2 } #end
blob {
  kernel "gaussian"
  sphere { 0, 1 }
  cylinder { x, x, 0.3 }
  cone { y, 0.2, y, 0.4 }
  torus { 0, 0.25 translate 2 * y }
  disc { z, y, 0, 0.1 }
  triangle { 0, x, 3 * x, 0.1 }           // on a line: its longest edge is left
  triangle { 3 * x, x, 0, 0.1 }
  triangle { y, y, y, 0.2 }
  triangle { 0, x, <1e-15, 0, 1e-16>, 0.1 }
  triangle { 0, x, <1, 1e-12, 0>, 0.1 }   // thin, and nothing else
  cylinder { 0, 1e-12 * x, 0.3 }          // short, and nothing else
  Generated(0)
}
blob {
  kernel "quartic"
  convolution on
  cylinder { x, x, 0.3 }
  torus { 0, 0.25 }
}
blob { threshold 0.5 cylinder { y, y, 1, 1 } }
