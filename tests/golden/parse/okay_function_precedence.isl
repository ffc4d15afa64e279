#declare F = function(x, y) { 1 | 0 & x + 1 < y * 2 }
#declare G = function { min(x > y, 1) - -x }
#declare H = function { pattern { bumps scale 2 } }
#declare I = function 300, Height { pattern { granite } }
#declare J = function(t) { 0 #for (I, 1, 3) + t*I #end }
#declare K = (1 | 0 & 0);
