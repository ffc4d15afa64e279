#declare A = 1;;;
#macro Nothing() #end
Nothing();
#macro Object() sphere { 0, 1 } #end
Object();
#declare V = <1; 2, 3>;
#declare S = "text";;
#macro Calls_itself(N) #if (N = 0) #break #end Calls_itself(N - 1) #end
Calls_itself(3);
