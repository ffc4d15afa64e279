// Blocks that begin or end in branches: what is executed is what counts.
#version 3.7;

// Cut or whole, merged or united.
#macro Ball(Cut, Merged)
  #if (Cut) difference { #end
    #if (Merged) merge { #else union { #end
      sphere { 0, 1 }
      sphere { x, 1 }
    }
  #if (Cut) box { 0, 2 } } #end
#end
Ball(0, 0)
Ball(1, 1)
#declare Cut_ball = Ball(1, 0)
object { Cut_ball translate 3 * y }

// The declaration stands in the branches, too, and what follows it belongs to its value.
#if (0) #declare Pair = intersection { #else #declare Pair = union { #end
  sphere { y, 0.3 }
  #for (I, 0, 3)
    #if (mod(I, 2)) object { #end
      sphere { I * x, 0.3 }
    #if (mod(I, 2)) translate y } #end
  #end
};
object { Pair }

// The value of a declaration is an `#if`.
#local Edge =
#if (1)
  #if (0) merge { #else union { #end
#end
  cylinder { 0, y, 0.1 }
#if (1) sphere { y, 0.2 } } #end;
object { Edge }

// All branches close what stands before them; a `#switch` opens.
union {
  torus { 1, 0.1
  #if (0) scale 2 } #else rotate 90 * x } #end
  #switch (2)
    #case (1) intersection { #break
    #range (2, 3) union { #break
  #end
    #for (I, 0, 1) box { I, I + 1 } #end
    #if (1) object { #end box { 2, 3 } #if (1) } #end
    #for (I, 3, 4) box { I, I + 1 } #end
  }
  blob { #if (1) threshold 0.5 } #else } #end
}
