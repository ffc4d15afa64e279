// A number's declaration may end twice: by a macro's own semicolon and by that of the call.
#macro Ended() 5; #end
#declare A = Ended();
#declare B = <1, #declare C = 2; C, 3>;
#macro Declares() #declare D = 4; #end
Declares();
#debug concat(vstr(3, B, ",", 0, 0), " ", str(A + C + D, 0, 0), "\n")
