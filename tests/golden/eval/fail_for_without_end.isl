#for (I, 0, 3)
  sphere { I*x, 1 }
