// Calls: the numbers of Fibonacci by a macro that calls itself (635,621 calls), and a macro that sets two of its caller's variables.
#version 3.7;
global_settings { assumed_gamma 1 }
#macro Fibonacci(N)
  #if (N < 2)
    N
  #else
    Fibonacci(N - 1) + Fibonacci(N - 2)
  #end
#end
#macro Turn(X, Y, Angle)
  #local Old = X;
  #declare X = Old * cos(Angle) - Y * sin(Angle);
  #declare Y = Old * sin(Angle) + Y * cos(Angle);
#end
#declare Total = Fibonacci(27);
#declare Px = 1;
#declare Py = 0;
#for (I, 1, 200000)
  Turn(Px, Py, 0.001)
#end
#debug concat(str(Total, 0, 0), " ", str(Px, 0, 6), " ", str(Py, 0, 6), "\n")
sphere { 0, 1 }
