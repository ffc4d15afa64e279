// A million turns of a #while with two assignments each.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare I = 0;
#declare Sum = 0;
#while (I < 1000000)
  #declare Sum = Sum + I * 0.5;
  #declare I = I + 1;
#end
sphere { 0, Sum }
