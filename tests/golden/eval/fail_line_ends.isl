#declare A = 1;#declare B = 2 // without a semicolonsphere { 0, Radius }
sphere { "ab", 1 }