// POV-Ray's own sequence.
#version 3.7;
#declare S = seed(42); #debug concat(str(rand(S), 0, 9), " ", str(rand(S), 0, 9), "\n")
#declare R = seed(1); #debug concat(str(rand(R), 0, 9), " ", str(rand(R), 0, 9), " ", str(rand(R), 0, 9), "\n")
#declare Q = seed(0); #debug concat(str(rand(Q), 0, 9), " ", str(rand(S), 0, 9), "\n")
#declare N = seed(-7); #debug concat(str(rand(N), 0, 9), " ", str(rand(N), 0, 9), "\n")
