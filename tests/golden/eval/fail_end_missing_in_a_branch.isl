// An error for POV-Ray 3.7 too, executed or not: "End of file reached but #end expected".
#if (0)
  #if (1) it's
#end
