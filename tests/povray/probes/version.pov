// The value of `version` where no file states one, and the values that `#version` sets.
#macro Say(Name) #debug concat(Name, " ", str(version, 0, 6), "\n") #end
Say("not stated")
#macro Old() #version 3.1; #end
#declare Before = version;
Old()
Say("stated in a macro")
#declare A = 1   // before 3.5 a declaration needs no semicolon
#version Before;
Say("put back")
#version version;
Say("itself")
#version 3.62;
Say("two decimals")
#version 3.625;
Say("rounded up")
#version 3.704;
Say("rounded down")
#version 3 + 0.5;
Say("an expression")
#version (version < 3.6 ? 3.6 : 3.7);
Say("a conditional")
#if (version >= 3.8) #version 3.8; #end
Say("no newer one")
#version 3.1;
#declare Bumps = function { pattern { bumps } }
#debug concat("the first noise ", str(Bumps(0.3, 0.4, 0.7), 0, 6), "\n")
#version 3.5;
#declare Bumps_2 = function { pattern { bumps } }
#debug concat("the second noise ", str(Bumps_2(0.3, 0.4, 0.7), 0, 6), "\n")
#version 3.1;
global_settings { noise_generator 3 }
#declare Bumps_3 = function { pattern { bumps } }
#debug concat("the third noise ", str(Bumps_3(0.3, 0.4, 0.7), 0, 6), "\n")
