// Tuples of another length, of something else, or at another place.
#version 3.8;
#declare (A, B) = (1, 2, 3);
#declare (C, D, E) = (1, 2);
#declare (F, G) = 5;
#declare (H, I) = (1, );
#declare (J, optional K) = (Nowhere, 1);
#declare L = (1, 2);
#macro Three() (1, 2, 3) #end
#declare (M, N) = Three();
#declare (O P) = (1, 2);
