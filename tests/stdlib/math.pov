// Prints samples of every function and macro (but Histogram, which POV-Ray 3.7 cannot run).
// Both programs read this scene with their own math.inc and must print the same (tests/stdlib/compare.py).
#version 3.7;
global_settings { assumed_gamma 1 }
#include "math.inc"
#macro Show(Text, V) #debug concat(Text, " ", str(V, 0, 9), "\n") #end
#macro Show3(Text, V) #debug concat(Text, " ", vstr(3, V, " ", 0, 9), "\n") #end
#macro Show5(Text, V) #debug concat(Text, " ", vstr(5, V, " ", 0, 6), "\n") #end
#declare A=array[5]{1,4,2,8,5}
#declare B=array[2]{<1,2,3>,<3,4,9>}
Show("mean",Mean(A)) Show3("meanv",Mean(B)) Show("sd",Std_Dev(A,4))
GetStats(A)
Show("st",StatisticsArray[0]) Show("st",StatisticsArray[1]) Show("st",StatisticsArray[2]) Show("st",StatisticsArray[3]) Show("st",StatisticsArray[4])
Show("dim",dimension_size(StatisticsArray,1))



#declare A2=array[4]{1,1,1,1}
Show("i",Interpolate(0.25,0,1,0,10,1))
Show("i",Interpolate(0.25,0,1,0,10,0))
Show("i",Interpolate(0.25,0,1,0,10,2))
Show("i",Interpolate(0.25,0,1,0,10,-2))
Show("i",Interpolate(0.75,0,1,3,10,-2))
Show("i",Interpolate(0.25,0,1,0,10,0.5))
Show("i",Interpolate(1.25,0,1,0,10,1))
Show("i",Interpolate(-0.25,0,1,0,10,1))
Show("i",Interpolate(3,2,7,-1,10,3))
Show("even",even(2)) Show("even",even(3)) Show("even",even(-4)) Show("even",even(2.5)) Show("odd",odd(3)) Show("odd",odd(2)) Show("odd",odd(-3)) Show("odd",odd(-2)) Show("odd", odd(2.5)) Show("even",even(-3))
Show("sgn",sgn(0)) Show("sgn",sgn(-2)) Show("sgn",sgn(3))
Show("clip",clip(5,0,3)) Show("clip",clip(-5,0,3)) Show("clip",clip(2,0,3))
Show("clamp",clamp(5,0,3)) Show("clamp",clamp(-5,0,3)) Show("clamp",clamp(2,0,3)) Show("clamp",clamp(4.5,1,3)) Show("clamp",clamp(-.5,1,3)) Show("clamp",clamp(3,1,3)) Show("clamp",clamp(1,1,3)) Show("clamp",clamp(3,0,3))
Show("adj",adj_range(.3,2,5)) Show("adj",adj_range(-1,2,5)) Show("adj2",adj_range2(3,1,5,10,20))
Show("s",sind(30)) Show("c",cosd(60)) Show("t",tand(45)) Show("as",asind(.5)) Show("ac",acosd(.5)) Show("at",atand(1)) Show("at2",atan2d(1,-1)) Show("max3",max3(1,5,3)) Show("min3",min3(4,1,3)) Show("sqr",f_sqr(-3))
Show3("vsqr",VSqr(<1,-2,3>)) Show3("vpow",VPow(<1,2,3>,2.5)) Show5("vp5",VPow5D(<1,2,3,4,5>,2))
Show("veq",VEq(<1,2,3>,<1,2,3>)) Show("veq",VEq(<1,2,3>,<1,2,3.1>)) Show("veq5",VEq5D(<1,2,3,4,5>,<1,2,3,4,5>))  Show("veq5",VEq5D(<1,2,3,4,5>,<1,2,3,4,6>))
Show("vz",VZero(<0,0,0>)) Show("vz",VZero(<0,1e-7,0>)) Show("vz",VZero(<0,1e-11,0>)) Show("vz5",VZero5D(<0,0,0,0,0>)) Show("vz5",VZero5D(<0,0,0,0,1>)) Show("veqt",VEq(<1,2,3>,<1,2,3+1e-7>))
Show("vl5",VLength5D(<1,2,3,4,5>)) Show5("vn5",VNormalize5D(<1,2,3,4,5>)) Show("vd5",VDot5D(<1,2,3,4,5>,<2,3,4,5,6>))
Show("ca",VCos_Angle(<1,2,3>,<-2,1,4>)) Show("an",VAngle(<1,2,3>,<-2,1,4>)) Show("and",VAngleD(<1,2,3>,<-2,1,4>))
Show("an",VAngle(x,x)) Show("an",VAngle(<1,2,3>,<1,2,3>*2))
Show("rot",VRotation(x,y,z)) Show("rot",VRotation(y,x,z)) Show("rotd",VRotationD(x,<1,1,0>,-z)) Show("rot0",VRotationD(x,<1,1,0>,<0,0,0>)) Show("rot0",VRotationD(y,x,<0,0,0>)) Show("rot",VRotationD(x,-x,z))  Show("rot",VRotationD(x,-x,-z))
Show("vd",VDist(<1,2,3>,<4,6,3>))
Show3("pv",VPerp_To_Vector(<1,2,3>)) Show3("pv",VPerp_To_Vector(<3,2,1>)) Show3("pv",VPerp_To_Vector(<0,2,0>)) Show3("pv",VPerp_To_Vector(<0,0,2>)) Show3("pv",VPerp_To_Vector(<2,0,0>))  Show3("pv",VPerp_To_Vector(<2,2,2>)) Show3("pv",VPerp_To_Vector(<-3,-1,2>)) Show3("pv",VPerp_To_Vector(<2,1,2>)) Show3("pv",VPerp_To_Vector(<1,1,2>)) Show3("pv",VPerp_To_Vector(<1,2,1>)) Show3("pv",VPerp_To_Vector(<1,0,2>)) Show3("pv",VPerp_To_Vector(<2,3,1>))
Show3("pp",VPerp_To_Plane(<1,2,3>,<3,1,0>))
Show3("pa",VPerp_Adjust(<1,2,3>,<3,1,0>)) Show3("pa",VPerp_Adjust(<1,2,3>,y))
Show3("pj",VProject_Plane(<1,2,3>,<3,1,0>)) Show3("px",VProject_Axis(<1,2,3>,<3,1,0>))
Show("mn",VMin(<3,1,2>)) Show("mx",VMax(<3,1,2>)) Show3("wl",VWith_Len(<1,2,2>,6))
#declare Fx=function(x,y,z){x*x+y*z} #declare Fy=function(x,y,z){x*y} #declare Fz=function(x,y,z){z*z*x}
Show("acc",__Gradient_Fn_Accuracy_)
#declare G=fn_Gradient(Fx) Show("G",G(1,2,3))
#declare GD=fn_Gradient_Directional(Fx,<1,1,0>) Show("GD",GD(1,2,3))
#declare DV=fn_Divergence(Fx,Fy,Fz) Show("DV",DV(1,2,3))
Show3("vG",vGradient(Fx,<1,2,3>)) Show3("curl",vCurl(Fx,Fy,Fz,<1,2,3>)) Show("div",Divergence(Fx,Fy,Fz,<1,2,3>)) Show("gl",Gradient_Length(Fx,<1,2,3>)) Show("gd",Gradient_Directional(Fx,<1,2,3>,<1,1,0>))
SetGradientAccuracy(0.1) Show("acc",__Gradient_Fn_Accuracy_) Show3("vG",vGradient(Fz,<1,2,3>))
