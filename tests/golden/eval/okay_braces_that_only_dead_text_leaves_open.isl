// POV-Ray 3.7 accepts each statement.
sphere { #if (0) 0, 2 } #end 0, 1 #if (0) { #end }
#if (0) merge { #else sphere { 1, 1 } #end
#if (1) sphere { 2, 1 } #else merge { #end
#if (0) merge { #elseif (0) union { #else sphere { 3, 1 } #end
#if (0) { #else #end
#macro Ball(Open) #if (Open) sphere { #end #if (!Open) sphere { 4, 1 } #else } #end #end
Ball(0)
#if (0) merge { #else union { #end sphere { 5, 1 } sphere { 6, 1 } }
