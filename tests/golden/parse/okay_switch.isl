#switch (A)
  #case (1) one
  #range (2, 5) few #break
  #else many
#end
#switch (A) #end
