// Arrays: 30,000 numbers are put into order by Shell's method, and the primes below 300,000 are sieved.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Count = 30000;
#declare Numbers = array[Count];
#declare State = 1;
#for (I, 0, Count - 1)
  #declare State = mod(State * 16807, 2147483647);
  #declare Numbers[I] = State;
#end
#declare Gap = 1;
#while (Gap < Count / 3)
  #declare Gap = 3 * Gap + 1;
#end
#while (Gap >= 1)
  #for (I, Gap, Count - 1)
    #declare Moved = Numbers[I];
    #declare J = I - Gap;
    #while (J >= 0)
      #if (Numbers[J] <= Moved)
        #break
      #end
      #declare Numbers[J + Gap] = Numbers[J];
      #declare J = J - Gap;
    #end
    #declare Numbers[J + Gap] = Moved;
  #end
  #declare Gap = int(Gap / 3);
#end
#declare Below = 300000;
#declare Crossed = array[Below];
#for (I, 0, Below - 1)
  #declare Crossed[I] = 0;
#end
#declare Primes = 0;
#for (I, 2, Below - 1)
  #if (Crossed[I] = 0)
    #declare Primes = Primes + 1;
    #for (J, 2 * I, Below - 1, I)
      #declare Crossed[J] = 1;
    #end
  #end
#end
#debug concat(str(Numbers[0], 0, 0), " ", str(Numbers[Count / 2], 0, 0), " ", str(Primes, 0, 0), "\n")
sphere { 0, 1 }
