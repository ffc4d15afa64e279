// Which noise patterns and functions take: the scene's, the pattern's own, or the one of the language's version.
#macro Say(Name, V) #debug concat(Name, " ", str(V, 0, 12), "\n") #end
#version 3.1;
#declare Bozo = function { pattern { bozo } }
#declare Bozo2 = function { pattern { bozo noise_generator 2 } }
#declare Noise = function { internal(76) }
#declare Marble = function { pattern { marble turbulence 0.4 } }
#macro Say_all(Name)
  Say(concat(Name, ", bozo"), Bozo(0.3, 0.4, 0.7))
  Say(concat(Name, ", bozo of the second"), Bozo2(0.3, 0.4, 0.7))
  Say(concat(Name, ", f_noise3d"), Noise(0.3, 0.4, 0.7))
  Say(concat(Name, ", marble"), Marble(0.3, 0.4, 0.7))
#end
Say_all("before 3.5")
#version 3.5;
Say_all("3.5")
#version 3.7;
Say_all("3.7")
global_settings { assumed_gamma 1 noise_generator 3 }
Say_all("the third")
global_settings { noise_generator 1 }
Say_all("the first")
#version 3.1;
global_settings { noise_generator 2 }
Say_all("the second, before 3.5")
