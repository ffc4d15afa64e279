// Prints samples of every macro.
// Both programs read this scene with their own transforms.inc and must print the same (tests/stdlib/compare.py).
#version 3.7;
global_settings { assumed_gamma 1 }
#include "transforms.inc"
#macro Show(Text, V) #debug concat(Text, " ", str(V, 0, 9), "\n") #end
#macro Show3(Text, V) #debug concat(Text, " ", vstr(3, V, " ", 0, 9), "\n") #end
#macro Show5(Text, V) #debug concat(Text, " ", vstr(5, V, " ", 0, 6), "\n") #end
#declare P=<1,2,3>;
#macro T(S,Tr) #local W=vtransform(P,Tr); Show3(S,W) #end
T("Shear",transform{Shear_Trans(<1,.2,0>,<.3,2,.1>,<0,.5,1>)})
T("Matrix",transform{Matrix_Trans(<1,.2,0>,<.3,2,.1>,<0,.5,1>,<4,5,6>)})
T("AxS",transform{Axial_Scale_Trans(<1,1,0>,3)})
T("AxS",transform{Axial_Scale_Trans(<0,-2,0>,.5)})
T("AxR",transform{Axis_Rotate_Trans(<1,2,3>,40)})
T("AxR",transform{Axis_Rotate_Trans(<1,2,-1>,40)})
T("RA",transform{Rotate_Around_Trans(<10,20,30>,<4,5,6>)})
T("Re",transform{Reorient_Trans(<1,2,3>,<-2,1,1>)})
T("Re",transform{Reorient_Trans(x,x)})
T("Re",transform{Reorient_Trans(x,-x)})
T("Re",transform{Reorient_Trans(y,-y*2)})
T("Re",transform{Reorient_Trans(<1,2,3>,-<1,2,3>)})
T("Re",transform{Reorient_Trans(x*4,y*2)})
T("Po",transform{Point_At_Trans(<1,2,3>)})
T("Po",transform{Point_At_Trans(y)})
T("Po",transform{Point_At_Trans(-y)})
T("Po",transform{Point_At_Trans(x)})
T("Po",transform{Point_At_Trans(<3,-2,1>)})
T("Po",transform{Point_At_Trans(<0,-2,1>)})
#declare O=box{<1,2,3>,<5,4,9>}
T("Ce",transform{Center_Trans(O,x)}) T("Ce",transform{Center_Trans(O,x+y)}) T("Ce",transform{Center_Trans(O,x+y+z)})  T("Ce",transform{Center_Trans(O,z*2)})
T("Al",transform{Align_Trans(O,x,<10,20,30>)}) T("Al",transform{Align_Trans(O,-y,<10,20,30>)}) T("Al",transform{Align_Trans(O,x-y+z,<10,20,30>)}) T("Al",transform{Align_Trans(O,<0,0,0>,<10,20,30>)}) T("Al",transform{Align_Trans(O,<.5,0,0>,<10,20,30>)})
Show3("vt",vtransform(<1,2,3>,transform{scale 2 rotate y*90 translate x}))
Show3("vit",vinv_transform(<1,2,3>,transform{scale 2 rotate y*90 translate x}))
#declare Spl=spline{natural_spline -1,<-1,0,0> 0,<0,0,0>, .5,<1,1,2>, 1,<2,0,3> 2,<5,1,2>}
T("Sp",transform{Spline_Trans(Spl,.3,y,.1,.5)})
T("Sp",transform{Spline_Trans(Spl,.3,y,.1,0)})
T("Sp",transform{Spline_Trans(Spl,.7,<0,1,.2>,.25,2)})
T("Sp",transform{Spline_Trans(Spl,.7,<0,1,.2>,.25,0)})
