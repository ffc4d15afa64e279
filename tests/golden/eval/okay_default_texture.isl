sphere { 0, 1 pigment { rgb 1 } }
#default { finish { ambient 0.5 } }
sphere { 0, 1 pigment { rgb 1 } }
#default { pigment { gradient x } normal { bumps 0.1 } }
sphere { 0, 1 }
sphere { 0, 1 translate 2*x }                 // the default stands in the world
sphere { 0, 1 pigment { scale 2 } }           // what is said changes the default
#default { texture { pigment { rgb x } } }
sphere { 0, 1 }
