// Values of a blob's components that POV-Ray takes: the radius is squared, and one of 0 has no field.
blob {
  threshold 0.5
  sphere { 0, -2, 1 }
  cylinder { -x, x, -1, 1 }
  component 1, -1.5, <0, 1, 0>
  sphere { 5*x, 0, 1 }
  component 1, 0, <0, 5, 0>
}
// Infinite numbers leave a component out.
blob { threshold 0.5 sphere { x, 1, 1 } sphere { 0, 1, 1/0 } cylinder { 0, x/0, 1, 1 } sphere { 0, 1/0, 1 } }
