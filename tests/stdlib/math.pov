// Prints samples of every function and macro (but Histogram, which POV-Ray 3.7 cannot run). Both programs read this scene with their own math.inc and must print the
// same (tests/stdlib/compare.py).
#version 3.7;
global_settings { assumed_gamma 1 }
#include "math.inc"
#macro N(Text, V) #debug concat(Text, " ", str(V, 0, 9), "\n") #end
#macro V3(Text, V) #debug concat(Text, " ", vstr(3, V, " ", 0, 9), "\n") #end
#macro V5(Text, V) #debug concat(Text, " ", vstr(5, V, " ", 0, 6), "\n") #end
#declare A=array[5]{1,4,2,8,5}
#declare B=array[2]{<1,2,3>,<3,4,9>}
N("mean",Mean(A)) V3("meanv",Mean(B)) N("sd",Std_Dev(A,4))
GetStats(A)
N("st",StatisticsArray[0]) N("st",StatisticsArray[1]) N("st",StatisticsArray[2]) N("st",StatisticsArray[3]) N("st",StatisticsArray[4])
N("dim",dimension_size(StatisticsArray,1))



#declare A2=array[4]{1,1,1,1}
N("i",Interpolate(0.25,0,1,0,10,1))
N("i",Interpolate(0.25,0,1,0,10,0))
N("i",Interpolate(0.25,0,1,0,10,2))
N("i",Interpolate(0.25,0,1,0,10,-2))
N("i",Interpolate(0.75,0,1,3,10,-2))
N("i",Interpolate(0.25,0,1,0,10,0.5))
N("i",Interpolate(1.25,0,1,0,10,1))
N("i",Interpolate(-0.25,0,1,0,10,1))
N("i",Interpolate(3,2,7,-1,10,3))
N("even",even(2)) N("even",even(3)) N("even",even(-4)) N("even",even(2.5)) N("odd",odd(3)) N("odd",odd(2)) N("odd",odd(-3)) N("odd",odd(-2)) N("odd", odd(2.5)) N("even",even(-3))
N("sgn",sgn(0)) N("sgn",sgn(-2)) N("sgn",sgn(3))
N("clip",clip(5,0,3)) N("clip",clip(-5,0,3)) N("clip",clip(2,0,3))
N("clamp",clamp(5,0,3)) N("clamp",clamp(-5,0,3)) N("clamp",clamp(2,0,3)) N("clamp",clamp(4.5,1,3)) N("clamp",clamp(-.5,1,3)) N("clamp",clamp(3,1,3)) N("clamp",clamp(1,1,3)) N("clamp",clamp(3,0,3))
N("adj",adj_range(.3,2,5)) N("adj",adj_range(-1,2,5)) N("adj2",adj_range2(3,1,5,10,20))
N("s",sind(30)) N("c",cosd(60)) N("t",tand(45)) N("as",asind(.5)) N("ac",acosd(.5)) N("at",atand(1)) N("at2",atan2d(1,-1)) N("max3",max3(1,5,3)) N("min3",min3(4,1,3)) N("sqr",f_sqr(-3))
V3("vsqr",VSqr(<1,-2,3>)) V3("vpow",VPow(<1,2,3>,2.5)) V5("vp5",VPow5D(<1,2,3,4,5>,2))
N("veq",VEq(<1,2,3>,<1,2,3>)) N("veq",VEq(<1,2,3>,<1,2,3.1>)) N("veq5",VEq5D(<1,2,3,4,5>,<1,2,3,4,5>))  N("veq5",VEq5D(<1,2,3,4,5>,<1,2,3,4,6>))
N("vz",VZero(<0,0,0>)) N("vz",VZero(<0,1e-7,0>)) N("vz",VZero(<0,1e-11,0>)) N("vz5",VZero5D(<0,0,0,0,0>)) N("vz5",VZero5D(<0,0,0,0,1>)) N("veqt",VEq(<1,2,3>,<1,2,3+1e-7>))
N("vl5",VLength5D(<1,2,3,4,5>)) V5("vn5",VNormalize5D(<1,2,3,4,5>)) N("vd5",VDot5D(<1,2,3,4,5>,<2,3,4,5,6>))
N("ca",VCos_Angle(<1,2,3>,<-2,1,4>)) N("an",VAngle(<1,2,3>,<-2,1,4>)) N("and",VAngleD(<1,2,3>,<-2,1,4>))
N("an",VAngle(x,x)) N("an",VAngle(<1,2,3>,<1,2,3>*2))
N("rot",VRotation(x,y,z)) N("rot",VRotation(y,x,z)) N("rotd",VRotationD(x,<1,1,0>,-z)) N("rot0",VRotationD(x,<1,1,0>,<0,0,0>)) N("rot0",VRotationD(y,x,<0,0,0>)) N("rot",VRotationD(x,-x,z))  N("rot",VRotationD(x,-x,-z))
N("vd",VDist(<1,2,3>,<4,6,3>))
V3("pv",VPerp_To_Vector(<1,2,3>)) V3("pv",VPerp_To_Vector(<3,2,1>)) V3("pv",VPerp_To_Vector(<0,2,0>)) V3("pv",VPerp_To_Vector(<0,0,2>)) V3("pv",VPerp_To_Vector(<2,0,0>))  V3("pv",VPerp_To_Vector(<2,2,2>)) V3("pv",VPerp_To_Vector(<-3,-1,2>)) V3("pv",VPerp_To_Vector(<2,1,2>)) V3("pv",VPerp_To_Vector(<1,1,2>)) V3("pv",VPerp_To_Vector(<1,2,1>)) V3("pv",VPerp_To_Vector(<1,0,2>)) V3("pv",VPerp_To_Vector(<2,3,1>))
V3("pp",VPerp_To_Plane(<1,2,3>,<3,1,0>))
V3("pa",VPerp_Adjust(<1,2,3>,<3,1,0>)) V3("pa",VPerp_Adjust(<1,2,3>,y))
V3("pj",VProject_Plane(<1,2,3>,<3,1,0>)) V3("px",VProject_Axis(<1,2,3>,<3,1,0>))
N("mn",VMin(<3,1,2>)) N("mx",VMax(<3,1,2>)) V3("wl",VWith_Len(<1,2,2>,6))
#declare Fx=function(x,y,z){x*x+y*z} #declare Fy=function(x,y,z){x*y} #declare Fz=function(x,y,z){z*z*x}
N("acc",__Gradient_Fn_Accuracy_)
#declare G=fn_Gradient(Fx) N("G",G(1,2,3))
#declare GD=fn_Gradient_Directional(Fx,<1,1,0>) N("GD",GD(1,2,3))
#declare DV=fn_Divergence(Fx,Fy,Fz) N("DV",DV(1,2,3))
V3("vG",vGradient(Fx,<1,2,3>)) V3("curl",vCurl(Fx,Fy,Fz,<1,2,3>)) N("div",Divergence(Fx,Fy,Fz,<1,2,3>)) N("gl",Gradient_Length(Fx,<1,2,3>)) N("gd",Gradient_Directional(Fx,<1,2,3>,<1,1,0>))
SetGradientAccuracy(0.1) N("acc",__Gradient_Fn_Accuracy_) V3("vG",vGradient(Fz,<1,2,3>))
