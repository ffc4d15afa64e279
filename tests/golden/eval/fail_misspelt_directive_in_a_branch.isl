// POV-Ray 3.7 passes over `#wile` and so takes the loop's #end for the branch's: the last one is too many there, too.
#if (0)
  #wile (1)
  #end
#end
