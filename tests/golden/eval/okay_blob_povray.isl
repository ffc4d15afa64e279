// POV-Ray's own components: the radius is the support's.
blob {
  threshold 0.6
  sphere { <1, 2, 3>, 2, strength 1.5 }
  sphere { x, 1, 1 }
  cylinder { 0, y, 0.5 1 }
  component 1, 0.75, <0, 0, 1>
  sturm
}
