// A macro may yield modifiers, and half an argument list.
#macro Look(C) pigment { C } finish { phong 1 } no_shadow #end
#macro Geometry() 0, 1 #end
sphere { Geometry() Look(rgb <1, .5, .25>) translate y }
