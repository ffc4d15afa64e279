// A kernel in force: ordinary solids as skeletons, the radius is the surface's.
blob {
  kernel "gaussian" hardness 2
  sphere { 0, 1 }
  cylinder { 0, 3*y, 0.3 }
  kernel "quartic"
  cone { 3*y, 0.3, <1, 4, 0>, 0.1 }
  cylinder { 0, x, 0.2 strength -1 }
}
