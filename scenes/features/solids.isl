// Every plain solid of the language, three rows on a table.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 9.5, -14> look_at <0, 0, 0.1> angle 48 }
light_source { <-7, 12, -9> rgb 0.85 }
light_source { <9, 7, -6> rgb <0.25, 0.28, 0.35> }
background { rgb <0.05, 0.06, 0.09> }

#declare Shine = finish { ambient 0.12 diffuse 0.7 specular 0.5 roughness 0.02 }
#macro Coloured(Hue)
  pigment { rgb <0.5 + 0.45 * cos(2 * pi * Hue), 0.5 + 0.45 * cos(2 * pi * (Hue - 1 / 3)), 0.5 + 0.45 * cos(2 * pi * (Hue - 2 / 3))> }
  finish { Shine }
#end
#macro Place(Column, Row) translate <2.5 * (Column - 2), 0, 2.7 * (1 - Row)> #end

plane { y, 0 pigment { rgb 0.75 } finish { ambient 0.1 diffuse 0.6 } }

// ---- Round and square --------------------------------------------------------------------------------------------------
sphere { 0.9 * y, 0.9 Coloured(0.00) Place(0, 0) }
box { <-0.75, 0, -0.75>, <0.75, 1.5, 0.75> rotate 25 * y Coloured(0.07) Place(1, 0) }
cylinder { 0, 1.6 * y, 0.7 Coloured(0.14) Place(2, 0) }
cone { 0, 0.9, 1.8 * y, 0.1 Coloured(0.21) Place(3, 0) }
torus { 0.7, 0.28 rotate -35 * x translate 0.75 * y Coloured(0.28) Place(4, 0) }

// ---- Rounded and algebraic ---------------------------------------------------------------------------------------------
superellipsoid { <0.25, 0.25> scale 0.75 rotate -90 * x rotate 30 * y translate 0.75 * y Coloured(0.35) Place(0, 1) }
superellipsoid { <1, 3.2> scale 1.05 rotate -90 * x translate 1.05 * y Coloured(0.40) Place(1, 1) }
// A hyperboloid of one sheet, a double cone's smooth cousin.
quadric { <1, -1, 1>, <0, 0, 0>, <0, 0, 0>, -0.15
  clipped_by { box { <-2, -0.9, -2>, <2, 0.9, 2> } } translate 0.9 * y Coloured(0.46) Place(2, 1) }
// Cayley's cubic: four singular points, as many as a cubic can have.
cubic { <0, 5, 5, -1, 5, 2, 0, 5, 0, -1, 0, 5, -1, 5, 0, -1, 0, -1, 0, 0>
  clipped_by { sphere { 0, 1 } } rotate <30, 25, 0> translate 1 * y Coloured(0.52) Place(3, 1) }
// Two tori at once would be of order 8; this is Kummer's cousin, the tangle cube x⁴ − 5x² + y⁴ − 5y² + z⁴ − 5z² + 11.8.
quartic { <1, 0, 0, 0, 0, 0, 0, 0, 0, -5, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
           1, 0, 0, 0, 0, -5, 0, 0, 0, 0, 1, 0, -5, 0, 11.8>
  scale 0.38 rotate 30 * y translate 0.92 * y Coloured(0.58) Place(4, 1) }

// ---- Flat, and a poly --------------------------------------------------------------------------------------------------
disc { 0, y, 0.85, 0.4 rotate -50 * x translate 0.75 * y Coloured(0.65) Place(0, 2) }
triangle { <-0.8, 0, -0.3>, <0.8, 0, -0.3>, <0, 1.5, 0.4> Coloured(0.72) Place(1, 2) }
smooth_triangle { <-0.9, 0.02, -0.3>, <-1, 0.4, -0.6>, <0.9, 0.02, -0.3>, <1, 0.4, -0.6>, <0, 1.5, 0.5>, <0, 1, -0.3>
  Coloured(0.78) Place(2, 2) }
polygon { 10, <-0.8, 0>, <0.8, 0>, <0.8, 1.5>, <-0.8, 1.5>, <-0.8, 0>,
  <0, 0.25>, <0.45, 0.75>, <0, 1.25>, <-0.45, 0.75>, <0, 0.25> rotate 15 * x rotate -20 * y Coloured(0.85) Place(3, 2) }
// A heart: (x² + 9/4 z² + y² − 1)³ − x² y³ − 9/80 z² y³ < 0, of order 6.
#declare C = array[84];
#for (I, 0, 83) #declare C[I] = 0; #end
// x⁶ is first; the place of x^a y^b z^c is found by counting down as the language does.
#macro Set(A, B, G, V)
  #local N = 6 - A;
  #local M = 6 - A - B;
  #local P = N * (N + 1) * (N + 2) / 6 + M * (M + 1) / 2 + (6 - A - B - G);
  #declare C[P] = C[P] + V;
#end
// (x² + y² + k z² − 1)³, by the multinomial theorem.
#declare K = 2.25;
#for (I, 0, 3)
  #for (J, 0, 3 - I)
    #for (L, 0, 3 - I - J)
      #local R = 3 - I - J - L;
      #local Ways = 6;
      #for (Q, 2, I) #local Ways = Ways / Q; #end
      #for (Q, 2, J) #local Ways = Ways / Q; #end
      #for (Q, 2, L) #local Ways = Ways / Q; #end
      #for (Q, 2, R) #local Ways = Ways / Q; #end
      Set(2 * I, 2 * J, 2 * L, Ways * pow(K, L) * pow(-1, R))
    #end
  #end
#end
Set(2, 3, 0, -1)
Set(0, 3, 2, -9 / 80)
poly { 6, < #for (I, 0, 83) C[I] #end >
  scale 0.68 translate 0.72 * y pigment { rgb <0.9, 0.1, 0.15> } finish { Shine } Place(4, 2) }
