// The fifth argument of trace: 0 where the ray cannot be decided, here next to a surface known to 1e-9 only.
#declare B = blob { threshold 1 kernel "cubic" hardness 3 sphere { <0, 0, 3e7>, 3e7 } cone { -1e-9, 1e-8, 1e-9, 2e-8 strength 3 } }
#declare C = 7; #declare N = <0,0,0>;
#declare P = trace(B, <0.001, 0.001, 0.001>, -<1,1,1>, N, C);
#debug concat(str(C,0,0), "\n")
#declare S = sphere { 0, 1 }
#declare P = trace(S, -5*z, z, N, C);
#debug concat(str(C,0,0), "\n")
