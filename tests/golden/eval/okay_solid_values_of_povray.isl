// What POV-Ray takes of solids, with a remark.
superellipsoid { <-0.5, 0.5> }
superellipsoid { <0, 0.5> }
superellipsoid { 0 }
superellipsoid { <0.5, -0.5> }
box { -1, <1/0, 1, 1> }
disc { 0, 0, 1 }
sphere { 0, 1/0 }
sphere { <1/0, 0, 0>, 1 }
cylinder { 0, y, 1/0 }
box { <0/0, 0, 0>, 1 }
quadric { <1/0, 1, 1>, <0, 0, 0>, <0, 0, 0>, -1 }
prism { linear_spline 0, 1, 4, <0, 0>, <1/0, 0>, <0, 1>, <0, 0> }
sphere { 0, 1 translate x/0 #declare Executed = 1; }
sphere { 0, 1 scale 1/0 }
union { sphere { 0, 1 } sphere { 0, 2/0 } }
#debug str(Executed, 0, 0)
