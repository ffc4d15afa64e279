// 75,025 calls of a macro that calls itself and yields a number.
#version 3.7;
global_settings { assumed_gamma 1 }
#macro Fibonacci(N)
  #if (N < 2)
    #local Result = N;
  #else
    #local Result = Fibonacci(N - 1) + Fibonacci(N - 2);
  #end
  Result
#end
#declare F = Fibonacci(24);
sphere { 0, F }
