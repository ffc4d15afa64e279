// Strings: 5,000 lines of 40 letters are put together, each is turned round, and its vowels are counted.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare State = 1;
#declare Vowels = 0;
#declare Same = 0;
#for (Line, 1, 5000)
  #declare Text = "";
  #for (I, 1, 40)
    #declare State = mod(State * 421 + 1663, 7875);
    #declare Text = concat(Text, chr(65 + mod(State, 26)));
  #end
  #declare Turned = "";
  #for (I, strlen(Text), 1, -1)
    #declare Letter = substr(Text, I, 1);
    #if (Letter = "A" | Letter = "E" | Letter = "I" | Letter = "O" | Letter = "U")
      #declare Vowels = Vowels + 1;
    #end
    #declare Turned = concat(Turned, Letter);
  #end
  #if (strlwr(Turned) = strlwr(Text))
    #declare Same = Same + 1;
  #end
#end
#debug concat(str(Vowels, 0, 0), " ", str(Same, 0, 0), " ", Turned, "\n")
sphere { 0, 1 }
