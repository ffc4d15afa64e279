// A macro that is given up at its first mistake tells the others, too. (POV-Ray 3.7 tells the first.)
#macro A()
  #declare B = 1 + ;
  sphere { 0, 2 * }
  box { 0, 1 $ }
#end
A()
sphere { 0, 3 - }
