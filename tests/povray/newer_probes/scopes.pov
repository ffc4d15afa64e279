// local. and global.: the innermost and the outermost scope by name.
#version 3.8;
global_settings { assumed_gamma 1 }
#macro Say(Name, V) #debug concat(Name, " ", str(V, 0, 6), "\n") #end
#declare F = 1;
#macro Three() #declare local.F = 2; Say("innermost", F) Say("global", global.F) Say("local", local.F) #end
Three()
Say("after it", F)
#macro Outer() #local F = 3; #declare global.F = 4; Say("hidden", F) #end
Outer()
Say("written outside", F)
#macro Asks() Say("local of the caller", defined(local.F)) Say("global", defined(global.F)) #end
Asks()
#macro Nested() #local G = 1; Inner() #end
#macro Inner() Say("the caller's local", G) Say("not local", defined(local.G)) Say("not global", defined(global.G)) #end
Nested()
#macro Removes() #local F = 5; #undef global.F Say("still hidden", F) #end
Removes()
Say("removed outside", defined(F))
#declare F = 6;
#macro Uncovers() #local F = 7; #undef local.F Say("uncovered", F) #end
Uncovers()
#declare global.A = array[2] { 1, 2 }
#macro Element() #local A = 5; Say("an element", global.A[1]) #declare global.A[0] = 9; #end
Element()
Say("an element written", A[0])
#macro Dictionary() #declare global.D = dictionary { .a: 5 } #end
Dictionary()
Say("a dictionary", D.a + 10*global.D.a)
#macro Ifdefs() #ifdef (local.F) Say("ifdef local", 1) #else Say("ifdef local", 0) #end #ifndef (global.Nothing) Say("ifndef global", 1) #end #end
Ifdefs()
#macro Takes(F) Say("a parameter is local", local.F) #end
Takes(12)
#macro Counter() #ifndef (global.Count) #declare global.Count = 0; #end #declare global.Count = global.Count + 1; #end
Counter() Counter() Counter()
Say("counted", Count)
Say("at the top", local.Count + global.Count)
