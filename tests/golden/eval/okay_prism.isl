// A contour ends where its first point comes again; the next one is a hole here.
prism { 0, 1, 8, <0, 0>, <3, 0>, <0, 3>, <0, 0>, <0.5, 0.5>, <1, 0.5>, <0.5, 1>, <0.5, 0.5> }
// Heights in any order, without caps; the last point is joined to the first, with a warning.
prism { linear_spline linear_sweep 1, -1, 3, <0, 0>, <1, 0>, <0, 1> open rotate 90*x }
prism { quadratic_spline 0, 1, 6, <-1, -1>, <1, -1>, <1, 1>, <-1, 1>, <-1, -1>, <1, -1> sturm }
prism { cubic_spline conic_sweep 0, 1, 7, <-1, 1>, <-1, -1>, <1, -1>, <1, 1>, <-1, 1>, <-1, -1>, <1, -1> }
prism { bezier_spline 0, 1, 8, <0, 0>, <1, -1>, <2, -1>, <3, 0>, <3, 0>, <2.5, 2>, <0.5, 1>, <0, 0> }
// An open curve is left out.
prism { bezier_spline 0, 1, 4, <0, 0>, <1, -1>, <2, -1>, <3, 0> }
prism { 1, 1, 3, <0, 0>, <1, 0>, <0, 1> }
#declare Bar = prism { 0, 1, 4, <0, 0>, <1, 0>, <0, 1>, <0, 0> }
prism { Bar translate x }
difference { prism { Bar } prism { Bar scale 0.5 } }
