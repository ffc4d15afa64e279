// Colours: their words in every order, promotion, items, arithmetic.
#version 3.7;
global_settings { assumed_gamma 1 }
#macro Say(Name, C) #debug concat(Name, " ", vstr(5, C, " ", 0, 6), "\n") #end
#macro Item(Name, X) #debug concat(Name, " ", str(X, 0, 6), "\n") #end
#declare A = rgb <0.1, 0.2, 0.3>; Say("rgb", A)
#declare A = rgbf <0.1, 0.2, 0.3, 0.4>; Say("rgbf", A)
#declare A = rgbt <0.1, 0.2, 0.3, 0.4>; Say("rgbt", A)
#declare A = rgbft <0.1, 0.2, 0.3, 0.4, 0.5>; Say("rgbft", A)
#declare A = rgb 0.5; Say("rgb of a number", A)
#declare A = rgbf 0.5; Say("rgbf of a number", A)
#declare A = rgbt 0.5; Say("rgbt of a number", A)
#declare A = rgbft 0.5; Say("rgbft of a number", A)
#declare A = rgbft <0.1, 0.2>; Say("of two", A)
#declare A = rgb <0.1, 0.2, 0.3>*2 + 0.1; Say("of an expression", A)
#declare A = color rgb <0.1, 0.2, 0.3> filter 0.7; Say("filter after", A)
#declare B = color A transmit 0.2; Say("transmit after a name", B)
#declare B = color A red 0.9 blue 0.8; Say("two after a name", B)
#declare B = red 0.1 green 0.2; Say("words alone", B)
#declare B = color red 0.1 green 0.2 blue 0.3 filter 0.4 transmit 0.5; Say("all words", B)
#declare B = colour blue 0.3; Say("colour", B)
#declare B = A + A; Say("a sum", B)
#declare B = A*2; Say("a product", B)
#declare B = A*<1, 2, 3>; Say("with a vector", B)
#declare B = A + 1; Say("with a number", B)
#declare B = -A; Say("negative", B)
#declare B = A/2; Say("halved", B)
#declare C = rgbft <0.1, 0.2, 0.3, 0.4, 0.5>;
Item("red", C.red) Item("green", C.green) Item("blue", C.blue) Item("filter", C.filter)
Item("transmit", C.transmit) Item("gray", C.gray) Item("x", C.x) Item("z", C.z) Item("t", C.t) Item("u", C.u)
Item("gray of a sum", (C + C).gray)
Item("item of a negative", -C.green)
#declare B = srgb <0.5, 0.2, 1>; Say("srgb", B)
#declare B = srgbt <0.5, 0.2, 1, 0.5>; Say("srgbt", B)
#declare B = srgbft <0.01, 0.04045, 0.7, 0.5, 0.25>; Say("srgbft", B)
#declare B = rgb (1 > 0); Say("of a comparison", B)
#declare B = rgb x + y; Say("of unit vectors", B)
#macro Mix(P, Q, F) (P*(1 - F) + Q*F) #end
#declare B = Mix(rgb <1, 0, 0>, rgb <0, 0, 1>, 0.25); Say("of a macro", B)
#declare D = array[2] { rgb <1, 0.5, 0>, color red 0.25 }
Say("in an array", D[1])
Item("an element's item", D[0].green)
