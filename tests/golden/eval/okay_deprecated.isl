// Each remark stands where POV-Ray 3.7 has it.
#declare deprecated A = 1;
#declare deprecated once B = 2;
#declare deprecated "use D" C = 3;
#declare deprecated once "use E" D = 4;
#declare X = A + B + C + D;
#declare X = B + D;
#ifdef (A) #end
#declare A = 5;
#declare X = A;
#macro Twice(P) #declare X = P; #declare P = 9; #end
Twice(A)
#declare deprecated F = function(x) { x + 1 }
#declare X = F(1);
#declare G = function(x) { F(x) + A }
#undef A
#declare A = 3;
#declare deprecated "too late" A = 2;
#declare X = A;
#declare deprecated R = array[2] { 1, 2 }
#declare R[1] = R[0];
#declare deprecated R[1] = 1;
#macro Local() #local deprecated L = 5; #declare X = L; #end
Local() Local()
#declare deprecated S = sphere { 0, 1 }
object { S }
#declare deprecated P = pigment { rgb 1 }
#declare deprecated N = finish { ambient 1 }
#declare deprecated M = transform { translate x }
sphere { 0, 1 pigment { P } finish { N } transform { M } }
#declare deprecated I = 3;
#for (I, 1, 3) #end
#declare deprecated Sky = sky_sphere { pigment { rgb 1 } }
sky_sphere { Sky }
#declare deprecated Curve = spline { 0, x 1, y }
#declare Copy = spline { Curve }
