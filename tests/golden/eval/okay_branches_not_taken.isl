// POV-Ray 3.7 accepts each line: what is not taken is searched for directives that nest, strings and comments only.
#if (0) it's #end
#if (0) #foo #for_ #frobnicate (1 #end
#if (0) #macro Q( #end #end
#if (0) a stray . here #end
#if (0) 1 + + #end
#if (0) } } ) ] ( [ { #end
#if (version >= 3.8) #declare D = dictionary { ["a"]: 1 }; #else #declare D = 1; #end
#if (0) 1e999 == && || % ^ @ ~ ` $ \ #end
#if (0) */ # #end
#if (0) "\q \z" "a
b" /* #end /* */ */ // #end
#end
#if (0) #local 3 = ; #declare = #undef #version #default { #include #fopen #read ( #write #end
#if (0) #if ( #else } #end #while #end #for #end #for (I #end #switch #end #switch (1) ; #end #ifdef #end #ifndef ( #end #end
#if (0) #while (1) #else #end #end
#if (0) #local ( #local #for (I #end #end
#if (0) union { / #if (1) #else #else #end function ( #end
#if (0) #macro A(1 + 2) #end #macro #end #macro B #end #end
#if (0) #wile (1) #end
#if (0) #include "nowhere.inc" #error "never" #break #end
#ifdef (Nope) dictionary { [ : ] #end
#ifndef (D) ; ; } #end
#debug concat("D = ", str(D, 0, 0), "\n")
