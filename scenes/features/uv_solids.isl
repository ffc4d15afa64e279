// uv_mapping on solids: patterns on the coordinates of the surface itself. A sphere has them like a globe, a torus along and
// around, a box as the cross that it unfolds to; every other solid has x and y of the world.
//   isl render scenes/features/uv_solids.isl -s 1200x500
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 3.2, -13> look_at <0, -0.15, 0> angle 48 right 2.4*x up y }
light_source { <6, 9, -8> rgb 0.95 }
light_source { <-8, 3, -6> rgb 0.3 shadowless }
background { rgb <0.93, 0.91, 0.87> }
#default { finish { ambient 0.15 diffuse 0.75 phong 0.3 phong_size 50 } }

plane { y, -1.1 pigment { rgb <0.80, 0.78, 0.74> } }

// Meridians and parallels.
sphere { 0, 1.05
  pigment { uv_mapping checker rgb <0.16, 0.30, 0.48>, rgb <0.93, 0.89, 0.80> scale <1/16, 1/8, 1> }
  rotate <0, 20, -23> translate -3.6*x
}

// Once around the ring u runs from 0 to 1, v around the tube: a stripe that winds five times.
torus { 0.95, 0.36
  uv_mapping
  pigment { gradient <1, 1, 0> color_map { [0.5 rgb <0.78, 0.30, 0.22>] [0.5 rgb <0.96, 0.85, 0.62>] } scale <1/5, 1, 1> * sqrt(0.5) }
  rotate <-48, 0, 12> translate <-1.05, -0.05, 0>
}

// Each face its own part of the cross: u in quarters, v in thirds.
#declare Ring = pigment { cylindrical color_map { [0.35 rgb <0.95, 0.93, 0.88>] [0.35 rgb <0.20, 0.45, 0.38>] [0.7 rgb <0.20, 0.45, 0.38>] [0.7 rgb <0.92, 0.70, 0.25>] } rotate 90*x translate <1, 1, 0> }
box { -0.75, 0.75
  texture { uv_mapping
    pigment { Ring warp { repeat 2*x } warp { repeat 2*y } scale <1/8, 1/6, 1> }
  }
  rotate <0, 32, 0> translate <1.55, -0.35, 0>
}

// x and y of the world, wherever it stands.
cylinder { -1.1*y, 0.9*y, 0.7
  pigment { uv_mapping gradient y color_map { [0.5 rgb <0.52, 0.36, 0.58>] [0.5 rgb <0.88, 0.82, 0.90>] } scale 0.4 }
  rotate 25*z translate <4.1, 0.1, 0>
}
