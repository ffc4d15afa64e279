// Patterns of tiles: Penrose's rhombs on the floor, his kites and darts on the wall, and paved slabs.
//   isl render scenes/features/tilings.isl -s 1000x500
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 4.2, -9> look_at <0, 0.5, 0> angle 50 right 2*x up y }
light_source { <5, 9, -7> rgb 0.9 }
light_source { <-6, 6, -6> rgb 0.35 shadowless }
background { rgb <0.85, 0.89, 0.93> }

#default { finish { ambient 0.15 diffuse 0.8 } }

// Tile k of K has the values from k/K, in its middle, to (k+1)/K, at its border.
#declare Caulk = rgb <0.25, 0.22, 0.2>;
#macro Tiles(First, Second)
  color_map { [0 First] [0.42 First] [0.42 Caulk] [0.5 Caulk] [0.5 Second] [0.92 Second] [0.92 Caulk] }
#end

plane { y, 0 pigment { tiling 27 Tiles(rgb <0.80, 0.72, 0.58>, rgb <0.45, 0.52, 0.55>) scale 0.45 } }
plane { z, 6 pigment { tiling 26 Tiles(rgb <0.86, 0.86, 0.80>, rgb <0.60, 0.30, 0.22>) rotate 90*x scale 0.6 } }

#declare Paved = color_map { [0 rgb <0.75, 0.45, 0.30>] [0.85 rgb <0.60, 0.32, 0.2>] [0.85 Caulk] [1 Caulk] }
#declare Slab = box { <-1, 0, -1>, <1, 0.25, 1> }
object { Slab pigment { pavement number_of_sides 4 number_of_tiles 5 pattern 5 color_map { Paved } scale 0.21 } rotate 20*y translate -2.8*x }
object { Slab pigment { pavement number_of_sides 3 number_of_tiles 6 pattern 12 exterior 2 form 2 color_map { Paved } scale 0.25 } }
object { Slab pigment { pavement number_of_sides 6 number_of_tiles 3 pattern 2 form 2 interior 2 color_map { Paved } scale 0.16 } rotate -20*y translate 2.8*x }
