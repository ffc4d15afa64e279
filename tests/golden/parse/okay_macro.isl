#macro Ring(Count, Radius)
  #local Step = 360 / Count;
  #for (I, 1, Count)
    sphere { vrotate(Radius*x, I*Step*y), 0.1 }
  #end
#end
