// A sign after an object begins the next argument.
#macro At(Shape, Place, Turn) object { Shape translate Place rotate Turn } #end
#macro Ball(R) sphere { 0, R } #end
#declare Box = box { 0, 1 }
At(Ball(2) -y, <0, 0, 90>)
At(Box -y*2 + x, 90*z)
At(Ball(1) +x -2*y -z, 45*z)
