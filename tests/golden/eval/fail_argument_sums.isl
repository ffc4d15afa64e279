// Elsewhere an object has no sum.
#macro At(Shape, Place) object { Shape translate Place } #end
#declare Box = box { 0, 1 }
#declare A = Box - y;
At(Box, Box - y)
At(Box * y)
