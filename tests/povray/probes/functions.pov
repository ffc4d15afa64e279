// function { … }: what may stand in one, and how it is computed.
#version 3.7;
#macro Say(Name, V) #debug concat(Name, " ", str(V, 0, 12), "\n") #end
#declare F1 = function(a) { 1|0&0 }                 Say("or and: and first", F1(0))
#declare F2 = function(a) { a=1 }                   Say("equal without slack", F2(1+1e-11) + 10*F2(1))
#declare F3 = function(a,b,c) { a<b<c }             Say("less less", F3(3,1,3) + 10*F3(0,1,0.5))
#declare F4 = function(a,b,c) { a=b<c }             Say("one level", F4(1,0,1) + 10*F4(1,1,0.5))
#declare F5 = function(a) { a&1 }                   Say("truth without slack", F5(1e-12) + 10*F5(0))
#declare F6 = function(a) { -a*a }                  Say("minus", F6(3))
#declare F7 = function(a) { 2*-a - -a }             Say("minus minus", F7(3))
#declare F8 = function(a) { 12/a/2*3 }              Say("from the left", F8(2))
#declare F9 = function(a) { select(a,1,2) }         Say("select of three", F9(-1) + 10*F9(0) + 100*F9(1))
#declare F10 = function(a) { select(a,1,2,3) }      Say("select of four", F10(-1) + 10*F10(0) + 100*F10(1e-12))
#declare F11 = function(a) { sum(i,1,a,i*i) }       Say("sum", F11(3) + 100*F11(3.5) + 10000*F11(0))
#declare F12 = function(a) { prod(i,1,a,i) }        Say("product", F12(4) + 100*F12(0))
#declare F13 = function(a) { sum(i,1,3,sum(j,1,i,a*i*j)) } Say("sum of sums", F13(1))
#declare F14 = function(a) { sum(i,0.5,3,i) }       Say("sum of halves", F14(1))
#declare F15 = function(a) { min(a,1,2)+max(a,1,2,3) } Say("min max", F15(0))
#declare F16 = function(a) { int(a)+10*floor(a)+100*ceil(a) } Say("to integers", F16(-3.7))
#declare F17 = function(a) { int(a) }               Say("int of much", F17(1e12))
#declare F18 = function(a,b) { mod(a,b)+10*div(a,b) } Say("mod div", F18(-7,3))
#declare F19 = function(a) { 1/a }                  Say("over zero", F19(0))
#declare F20 = function(a) { ln(a) }                Say("ln of zero", F20(0))
#declare F21 = function(a) { pow(0,a) }             Say("zero to the power of zero", F21(0))
#declare F22 = function(a) { exp(a)+asinh(a)+cosh(a)+sinh(a)+tanh(a)+tan(a)+atan(a)+atan2(a,2)+abs(-a) } Say("many", F22(0.3))
#declare F23 = function(a) { acosh(a+1)+atanh(a)+asin(a)+acos(a)+sqrt(a)+log(a)+cos(a)+sin(a) } Say("more", F23(0.3))
#declare F24 = function(a) { degrees(a)+radians(a)+pi+clock } Say("angles", F24(0.3))
#declare F25 = function { x+10*y+100*z }            Say("x y z", F25(1,2,3))
#declare F26 = function { u+10*v }                  Say("u v", F26(1,2,3))
#declare F27 = function(u,v) { x+10*y }             Say("x y for u v", F27(1,2))
#declare F28 = function(z,y,x) { z+10*y+100*x }     Say("in their order", F28(1,2,3))
#declare F29 = function(x,x) { x*2 }                Say("the same twice", F29(2,3))
#declare F30 = function(a b) { a/b }                Say("no commas", F30(1 3))
#declare K = 3;
#declare F31 = function(a) { K*a }
#declare K = 5;                                     Say("captured", F31(2))
#declare A = array[2] {3, 4}
#declare F32 = function(a) { A[1]*a }               Say("an element", F32(2))
#macro Twice(P) P*2 #end
#declare F33 = function(a) { Twice(3)+1 }           Say("a macro", F33(0))
#macro Of_X() x*x #end
#declare F34 = function { Of_X()+1 }                Say("a macro of parameters", F34(3,0,0))
#declare F35 = function(a) { 0 #for (I,1,3) + I*a #end } Say("a loop", F35(2))
#declare F36 = function(a) { a #if (1) +1 #end }    Say("a branch", F36(2))
#declare F37 = function(a) { F36(F36(a))+F25(a,1,2) } Say("other functions", F37(2))
#declare F38 = function { transform { scale 2 translate <1,2,3> } }
Say("transform", F38(1,1,1).y)
#declare F39 = function(a) { F38(a,a,a).x+10*F38(a,a,a).z } Say("its items", F39(1))
#declare F40 = function { pigment { rgb <1,0.5,0.25> } }
Say("pigment", F40(0,0,0).green)
#declare F41 = function { F40(x,y,z).gray+10*F40(x,y,z).hf } Say("gray and height", F41(0,0,0))
#declare F42 = function(a) { a }
#declare F43 = F42;                                 Say("a copy", F43(4))
#declare B = array[2] { function(a) { a }, function(a) { 2*a } }
Say("in an array", B[1](2))
#macro Call(F) F(3) #end                            Say("through a macro", Call(F42))
#macro Make(F) #local G = function(a) { F(a)+1 } G(3) #end Say("made in a macro", Make(F42))
Say("of a literal", Call(function(a) { 7*a }))
#undef F42
#declare F42 = function(a) { -a }                   Say("declared again", F42(1))
Say("in arithmetic", 2*F42(1)+F42(2)*3)
