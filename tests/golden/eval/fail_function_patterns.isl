// These patterns are not functions of a point alone.
#declare A = function { pattern { slope y } }
#declare B = function { pattern { average } }
#declare C = function { pattern { rgb 1 } }
#declare D = function { pattern { bozo color_map { [0 rgb 0] } } }
#declare E = function { pattern { facets coords 1 } }
sphere { 0, 1 pigment { function (a, b) { a + b } } }
sphere { 0, 1 pigment { function { transform { scale 2 } } } }
#declare F = function 2, 2 { x }
#declare G = function { pattern { density_file df3 "ball.df3" } }
#declare H = function { pattern { bozo frequncy 2 } }
#debug str(G(1, 2, 3), 0, 3)
