// Arithmetic of numbers; printed by POV-Ray 3.7 alike.
#version 3.7;
#macro T(X) #debug concat(str(X, 0, 6), "\n") #end
T(7/2) T(div(-7, 2)) T(mod(-7, 2)) T(int(-1.5)) T(int(-0.5)) T(mod(7, 3)) T(mod(-7.5, 2)) T(div(7.9, 2))
T(2-3-4) T(2/4/2) T(-2*3) T(2+3*4) T((2+3)*4)
T(pow(2, 10)) T(min(3, 1, 2)) T(max(3, 1, 2)) T(ln(2)) T(log(1000)) T(exp(1)) T(sqrt(2)) T(abs(-2))
T(floor(-1.5)) T(ceil(-1.5)) T(atan2(1, -1)) T(sin(1)) T(cos(1)) T(tan(1)) T(asin(.5)) T(acos(.5)) T(atan(2))
T(sinh(1)) T(cosh(1)) T(tanh(1)) T(asinh(1)) T(acosh(2)) T(atanh(.5)) T(degrees(pi)) T(radians(180))
T(select(-1, 1, 2, 3)) T(select(0, 1, 2, 3)) T(select(1, 1, 2, 3)) T(select(0, 1, 2))
T(bitwise_and(12, 10)) T(bitwise_or(12, 10)) T(bitwise_xor(12, 10))
T(pi) T(on) T(no) T(yes + true)
