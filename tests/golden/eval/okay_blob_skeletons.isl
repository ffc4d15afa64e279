// Solids as skeletons: what each becomes, and how transforms stay beside those that have no ends.
blob {
  kernel "soft" hardness 2
  box { <1, 2, 3>, <0, 4, 1>, 0.25 }
  torus { 2, 0.5 rotate 90 * x }
  triangle { 0, x, y, 0.1 strength 0.5 }
  triangle { x, y, z, 0.2, strength -1 scale 2 }
  cylinder { 0, y, 0.3 scale 2 }
  disc { y, 2 * z, 1.5, 0.25 }
  disc { 0, -y, 0.5, 0.1 strength -2 rotate 45 * x }
}
