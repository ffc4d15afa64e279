// Doubtful, and read all the same.
#declare A = 1 / 0;
#declare B = acos(1.5);
#declare C = vnormalize(0);
#declare D = rgb <1, 2, 3, 4>;
#warning "as the scene says"
sphere { 0, 1 scale <1, 0, 1> }
blob { sphere { 0, 1, 0 } }
