// A blob of 200 components that all overlap: long lists in every cell.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> look_at 0 angle 40 }
light_source { <4, 6, -8>, 1 }
light_source { <-6, 2, -4>, 0.4 }
#declare Random = seed(7);
blob {
  threshold 4
  #for (I, 1, 200)
    sphere { <rand(Random) - 0.5, rand(Random) - 0.5, rand(Random) - 0.5> * 3, 1.1, 0.5 }
  #end
  pigment { rgb <0.9, 0.5, 0.3> }
  finish { ambient 0.1 diffuse 0.6 phong 0.4 }
}
