sphere { 0, 0 }
cylinder { 0, y, 0 }
cone { 0, 0, y, 0 }
torus { 1, 0 }
disc { 0, y, 1, 1 }
box { 0, <1, 0, 1> }
triangle { 0, x, 2*x }
smooth_triangle { 0, -z, x, -z, y, z }
smooth_triangle { 0, -z, x, -z, y, 0 }
polygon { 3, 0, x, 2*x }
polygon { 3, 0, x, y }
polygon { 9, 0, 4*x, 4*(x + y), 4*y, 0, <1, 1>, <2, 1>, <2, 2>, <1, 1> }
polygon { 5, 0, x, <1, 1, .5>, y, 0 }
quadric { 0, 0, 0, -1 }
