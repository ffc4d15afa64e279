// #if, #elseif, #ifdef, #ifndef, and what counts as true.
#version 3.7;
#macro Say(Name, V) #debug concat(Name, " ", str(V, 0, 6), "\n") #end
#macro Truth(Name, X) #if (X) Say(Name, 1) #else Say(Name, 0) #end #end
Truth("zero", 0)
Truth("negative", -1)
Truth("within the slack", 1e-11)
Truth("beyond the slack", 1e-9)
Truth("equal within the slack", (1 = 1 + 1e-11))
Truth("not equal beyond it", (1 != 1 + 1e-9))
Truth("less without slack", (1 < 1 + 1e-11))
Truth("at most with slack", (1 + 1e-11 <= 1))
Truth("at least with slack", (1 >= 1 + 1e-11))
Truth("not", !0)
Truth("not of much", !5)
Truth("not not", !!5)
Truth("strings that are equal", ("a" = "a"))
Truth("strings that are not", ("a" = "b"))
Truth("strings in order", ("a" < "b"))
Truth("strings by length", ("ab" > "a"))
Truth("strings by case", ("a" >= "A"))
Truth("and before or", (1 | 0 & 0))
Truth("in parentheses", (1 | (0 & 0)))
#macro Which(N)
  #if (N < 0) #local R = -1; #elseif (N = 0) #local R = 0; #elseif (N < 10) #local R = 1; #else #local R = 2; #end
  R
#end
Say("negative", Which(-5))
Say("zero", Which(0))
Say("below ten", Which(5))
Say("the rest", Which(50))
#ifdef (Nope) #declare A = 1; #elseif (1) #declare A = 2; #else #declare A = 3; #end
Say("elseif of ifdef", A)
#ifndef (A) Say("ifndef", 1) #else Say("ifndef", 0) #end
#if (0) #if (1) Say("no", 1) #else Say("no", 2) #end #else Say("nested", 3) #end
#if (1) #else #error "not taken" #end
#declare B = (A = 2 ? 10 : 20);
Say("a conditional", B)
#declare B = (0 ? 1 : 0 ? 2 : 3);
Say("conditionals in a row", B)
#declare C = ((1 < 2) + (2 < 3))*10;
Say("truths are numbers", C)
#declare D = <(1 < 2), (2 < 1), (1 = 1)>;
Say("comparisons in a vector", D.x + 10*D.y + 100*D.z)
Say("from the left", (3 > 2 > 1))
Say("defined", defined(A) + 10*defined(Nope))
