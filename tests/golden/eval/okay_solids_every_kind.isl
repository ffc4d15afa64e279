// Each solid once, with what POV-Ray mends silently: corners in any order, negative radii, normals of any length.
box { <1, -2, 3>, <-1, 2, -3> }
torus { 2, -.5 sturm }
disc { x, <0, 2, 0>, 2 }
disc { x, y, 2, .5 }
quadric { <1, 2, 3>, <4, 5, 6>, <7, 8, 9>, 10 }
cubic { <1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, -1> sturm }
quartic { <1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, -1> sturm off }
poly { 2, <1, 0, 0, 0, 1, 0, 0, 1, 0, -1> }
superellipsoid { <.25, .5> }
superellipsoid { 1 }
triangle { 0, x, y }
smooth_triangle { 0, -2*z, x, -z, y, <.1, 0, -1> }
polygon { 4, 0, x, x + y, 0 }
cone { 0, -1, 2*y, 0 open }
// An object of any kind may be copied where geometry could stand.
#declare Cube = box { 0, 1 }
torus { Cube translate x }
