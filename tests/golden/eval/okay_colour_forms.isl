// Every form of a colour, as five terms. The values are what POV-Ray 3.7 prints.
#version 3.7;
global_settings { assumed_gamma 1 }
#macro Show(Name, C) #debug concat(Name, " ", vstr(5, C, " ", 0, 3), "\n") #end
#declare A = rgb .5; Show("rgb number", A)
#declare A = rgbf .5; Show("rgbf number", A)
#declare A = rgbt .5; Show("rgbt number", A)
#declare A = rgbft .5; Show("rgbft number", A)
#declare A = rgb <1,2>; Show("rgb 2 terms", A)
#declare A = rgbt <1,2,3>; Show("rgbt 3 terms", A)
#declare A = rgbf <1,2,3,4>; Show("rgbf 4 terms", A)
#declare A = rgbt <1,2,3,4>; Show("rgbt 4 terms", A)
#declare A = rgbft <1,2,3,4,5>; Show("rgbft 5 terms", A)
#declare A = color red 1 green .5; Show("components", A)
#declare B = color A transmit .5; Show("override", B)
#declare B = color rgb <.1,.2,.3> transmit .5; Show("rgb override", B)
#declare B = color <.1,.2,.3>; Show("color vector", B)
#declare B = colour .3; Show("colour number", B)
#declare B = A + 0.1; Show("plus number", B)
#declare B = A * <1,2,3>; Show("times vector", B)
#debug concat("gray ", str(A.gray, 0, 6), "\n")
