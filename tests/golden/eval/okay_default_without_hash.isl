// Old scenes write `default` without its #.
default { texture { pigment { rgb 1 } finish { ambient 0.5 } } }
sphere { 0, 1 }
