// Sorts, turns round, resizes and draws items.
// Both programs read this scene with their own files of these names and must print the same (tests/stdlib/compare.py).
#version 3.7;
global_settings { assumed_gamma 1 }
#include "arrays.inc"
#declare S = seed(5);
#declare A = array[40]
#declare I = 0;
#while (I < 40) #declare A[I] = floor(100*rand(S)); #declare I = I + 1; #end
#macro Show(Text, A)
  #debug concat(Text, " ")
  #local I = 0;
  #while (I < dimension_size(A, 1))
    #ifdef (A[I]) #debug concat(str(A[I], 0, 0), " ") #else #debug "none " #end
    #local I = I + 1;
  #end
  #debug "\n"
#end
#declare B = A; Sort_Array(B) Show("Sorted", B)
#declare B = A; Sort_Partial_Array(B, 5, 12) Show("Part", B)
#declare B = A; Reverse_Array(B) Show("Reversed", B)
#declare B = A; Resize_Array(B, 7) Show("Shorter", B)
Resize_Array(B, 10) Show("Longer", B)
#declare I = 0;
#while (I < 9) #debug concat("Item ", str(Rand_Array_Item(A, S), 0, 0), "\n") #declare I = I + 1; #end
#macro Sort_Compare(Array, IdxA, IdxB) (Array[IdxA] > Array[IdxB]) #end
#declare B = A; Sort_Array(B) Show("Falling", B)
