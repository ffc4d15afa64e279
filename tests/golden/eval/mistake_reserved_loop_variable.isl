#for (t, 0, 2, 0.5)
  sphere { t*x, 0.2 }
#end
