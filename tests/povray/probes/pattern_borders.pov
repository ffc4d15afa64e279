// Colourings of fractals; and points on the borders of patterns, where POV-Ray says to which side they belong.
#version 3.7;
#macro Points(Name, F)
  #debug concat(Name, "\n")
  #local S = seed(11);
  #for (I, 1, 30)
    #local X = 3*rand(S)-2; #local Y = 3*rand(S)-1.5;
    #debug concat(" ", str(F(X,Y,0),0,12), "\n")
  #end
#end
#macro Borders(Name, F)
  #debug concat(Name, "\n")
  #for (I, -2, 2) #for (J, -2, 2) #for (K, -1, 1)
    #debug concat(" ", str(F(I/2,J/2,K/2),0,0), str(F(I/2+1e-9,J/2,K/2),0,0), str(F(I/2-1e-9,J/2,K/2-1e-9),0,0))
    #debug concat(str(F(I,J,K),0,0), str(F(I-1e-11,J-1e-11,K-1e-11),0,0), str(F(I*3,J*3,K*3),0,0), "\n")
  #end #end #end
#end
Points("exterior 0", function { pattern { mandel 40 exterior 0, 0.13 } })
Points("exterior 1", function { pattern { mandel 40 exterior 1, 0.13 } })
Points("exterior 2", function { pattern { mandel 40 exterior 2, 0.13 } })
Points("exterior 3", function { pattern { mandel 40 exterior 3, 0.13 } })
Points("exterior 4", function { pattern { mandel 40 exterior 4, 0.13 } })
Points("exterior 5", function { pattern { mandel 40 exterior 5, 0.13 } })
Points("exterior 6", function { pattern { mandel 40 exterior 6, 0.13 } })
Points("interior 0", function { pattern { mandel 25 interior 0, 0.37 } })
Points("interior 1", function { pattern { mandel 25 interior 1, 0.37 } })
Points("interior 2", function { pattern { mandel 25 interior 2, 0.37 } })
Points("interior 3", function { pattern { mandel 25 interior 3, 0.37 } })
Points("interior 4", function { pattern { mandel 25 interior 4, 0.37 } })
Points("interior 5", function { pattern { mandel 25 interior 5, 0.37 } })
Points("interior 6", function { pattern { mandel 25 interior 6, 0.37 } })
Points("magnet interior 1", function { pattern { magnet 1 mandel 9 interior 1, 0.3 } })
Points("julia interior 1", function { pattern { julia <0.3,0.5>, 9 interior 1, 0.3 } })
Points("magnet exterior 1", function { pattern { magnet 2 mandel 9 exterior 1, 0.3 } })
Points("magnet interior 4", function { pattern { magnet 1 mandel 9 interior 4, 0.3 } })
Points("julia interior 4", function { pattern { julia <0.3,0.5>, 9 interior 4, 0.3 } })
Points("magnet exterior 4", function { pattern { magnet 2 mandel 9 exterior 4, 0.3 } })
Points("magnet interior 6", function { pattern { magnet 1 mandel 9 interior 6, 0.3 } })
Points("julia interior 6", function { pattern { julia <0.3,0.5>, 9 interior 6, 0.3 } })
Points("magnet exterior 6", function { pattern { magnet 2 mandel 9 exterior 6, 0.3 } })
Points("cubic julia", function { pattern { julia <0.4,0.5>, 15 exponent 3 exterior 6, 0.1 } })
Borders("checker", function { pattern { checker } })
Borders("brick", function { pattern { brick } })
Borders("brick brick_size <1,1,1> mortar 0.25", function { pattern { brick brick_size <1,1,1> mortar 0.25 } })
Borders("cubic", function { pattern { cubic } })
Borders("cells frequency 0", function { pattern { cells frequency 0 } })
Borders("radial", function { pattern { radial } })
Borders("quilted", function { pattern { quilted } })
Borders("boxed", function { pattern { boxed } })
#declare P = function { pigment { square rgb 0 rgb 1 rgb 2 rgb 3 } }
Borders("square", function { P(x, y, z).red })
#undef P
#declare P = function { pigment { hexagon rgb 0 rgb 1 rgb 2 } }
Borders("hexagon", function { P(x, y, z).red })
#undef P
#declare P = function { pigment { triangular rgb 0 rgb 1 rgb 2 rgb 3 rgb 4 rgb 5 } }
Borders("triangular", function { P(x, y, z).red })
#undef P
