#while (I < 10)
  #if (I = 3)
    sphere { 0, I }
#end
