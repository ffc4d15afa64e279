// Spikes thinner than a pixel, for urchin.sh: one for every column of a square picture of Pixels, of Radius pixels. They lean over by one
// column from bottom to top, so that samples in the middles of pixels meet them anywhere, and go on beyond the picture.
// What share of the picture they cover: 2 Radius sqrt(1 + 1/Pixels²).
#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (Radius) #declare Radius = 0.02; #end
#ifndef (Pixels) #declare Pixels = 64; #end

// So far away that rays are parallel to a thousandth, which widens a spike by a millionth of its width.
#declare Distance = 1000 * Pixels;
camera { location <Pixels / 2, Pixels / 2, -Distance> direction Distance * z right Pixels * x up Pixels * y }
blob {
  kernel "quartic" hardness 6
  #for (I, -3, Pixels + 2)
    cylinder { <I - 1, -Pixels, 0>, <I + 2, 2 * Pixels, 0>, Radius }
  #end
  pigment { rgb 1 }
}
