#declare A = function { { } }
#declare B = function (x) { { x } }
sphere { 0, 1 pigment { function { { } } } }
#declare C = function { { 1 } }
#declare D = function { sphere { 0, 1 } }
#declare E = function { array[2] { 1, 2 } }
#declare F = function { function { x } }
