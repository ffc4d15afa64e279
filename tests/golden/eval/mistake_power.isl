#declare Round = function (x, y, z) { x^2 + y^2 - 1 }
