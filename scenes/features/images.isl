// Images from files in colours, bumps and the choice of materials. images/make_images.py makes the files.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.6, -6.4> look_at <0.1, 0.8, 0> angle 50 right x*image_width/image_height }
light_source { <-5, 8, -6>, rgb 0.9 }
light_source { <6, 4, -3>, rgb <0.25, 0.28, 0.35> shadowless }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.75, 0.78, 0.8>] [0.6 rgb <0.25, 0.38, 0.55>] } } }

fog { distance 120 rgb <0.72, 0.75, 0.78> }

// A floor whose stones are chosen by the numbers of an image with a palette.
#declare Dull = finish { ambient 0.1 diffuse 0.7 }
#declare Polished = finish { ambient 0.1 diffuse 0.6 phong 0.4 phong_size 60 reflection 0.12 }
plane { y, 0
  texture {
    material_map { png "images/tiles.png"
      texture { pigment { rgb 0.09 } finish { Dull } }
      texture { pigment { granite scale 0.2 color_map { [0 rgb <0.80, 0.74, 0.62>] [1 rgb <0.55, 0.50, 0.42>] } } finish { Dull } }
      texture { pigment { rgb <0.05, 0.16, 0.24> } finish { Polished } }
      texture { pigment { rgb <0.42, 0.07, 0.04> } finish { Polished } }
    }
    rotate 90*x translate -0.5 scale 0.8
  }
}

// A globe: longitude and latitude of a sphere, smooth between pixels.
sphere { 0, 1
  pigment { image_map { png "images/globe.png" map_type 1 interpolate 2 } rotate 150*y }
  finish { ambient 0.1 diffuse 0.8 phong 0.5 phong_size 40 }
  rotate 23*z translate <-1.75, 1, 0.3>
}

// A medal: bumps from heights, which bend the light alone.
cylinder { -0.08*z, 0.08*z, 0.98
  texture {
    pigment { rgb <0.78, 0.52, 0.20> }
    normal { bump_map { png "images/rosette.png" interpolate 2 once bump_size 6 } translate -0.5*(x + y) scale 1.96 }
    finish { ambient 0.08 diffuse 0.45 metallic specular 0.7 roughness 0.04 reflection { 0.12 metallic } }
  }
  rotate <14, 12, 0> translate <0.35, 0.98, 0.4>
}

// Leaves on a jar: one image around it, repeated, with alpha; the glaze below shows through.
cylinder { 0, 1.5*y, 0.62
  texture { pigment { rgb <0.86, 0.84, 0.78> } finish { ambient 0.1 diffuse 0.75 } }
  texture {
    pigment { image_map { png "images/leaf.png" map_type 2 interpolate 2 repeat <7, 1> } scale <1, 1.5, 1> }
    finish { ambient 0.1 diffuse 0.75 phong 0.3 }
  }
  translate <2.15, 0, 0.2>
}
torus { 0.62, 0.07 pigment { rgb <0.32, 0.10, 0.05> } finish { Polished } translate <2.15, 1.5, 0.2> }
torus { 0.62, 0.07 pigment { rgb <0.32, 0.10, 0.05> } finish { Polished } translate <2.15, 0.07, 0.2> }
