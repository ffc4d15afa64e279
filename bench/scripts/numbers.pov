// Numbers: how fast the points of a grid escape under z² + c, 25 turns at most (1,048,395 turns in all).
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Width = 400;
#declare Height = 300;
#declare Total = 0;
#for (Row, 0, Height - 1)
  #declare Ci = Row / Height * 2.4 - 1.2;
  #for (Column, 0, Width - 1)
    #declare Cr = Column / Width * 3.2 - 2.2;
    #declare Zr = 0;
    #declare Zi = 0;
    #declare Turns = 0;
    #while (Turns < 25 & Zr * Zr + Zi * Zi < 4)
      #declare Next = Zr * Zr - Zi * Zi + Cr;
      #declare Zi = 2 * Zr * Zi + Ci;
      #declare Zr = Next;
      #declare Turns = Turns + 1;
    #end
    #declare Total = Total + Turns;
  #end
#end
#debug concat(str(Total, 0, 0), "\n")
sphere { 0, 1 }
