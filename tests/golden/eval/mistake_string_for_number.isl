#declare Steps = "8";
#for (K, 1, Steps)
  sphere { K*x, 0.4 }
#end
