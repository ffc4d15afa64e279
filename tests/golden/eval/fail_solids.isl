cylinder { x, x, 1 }
cone { 0, 1, 0, 2 }
disc { 0, 0, 1 }
superellipsoid { <0, 1> }
superellipsoid { "a" }
cubic { <1, 2, 3> }
poly { 1, <1, 2, 3, 4> }
poly { 36, <1> }
poly { 2, 1 }
polygon { 2, 0, x }
torus { 1, .2 open }
sphere { 0, 1 sturm }
torus { 1, .2 hierarchy }
box { 0 }
