// Soft light for scenes that have lamps only: `isl render scenes/gallery/coral_tree.isl -D Soft=1`.
#version 3.7;

// A lamp of the width Size at Key, a sky above Up whose light counts up to Reach, and what surfaces throw on one another.
#macro Soft_studio(Key, Size, Up, Reach)
  global_settings { sky_light { distance Reach } bounce_light { distance Reach } }
  sky_sphere {
    pigment {
      gradient Up
      color_map { [0 rgb <0.62, 0.55, 0.5>] [0.45 rgb <0.72, 0.72, 0.74>] [0.6 rgb <0.66, 0.74, 0.85>] [1 rgb <0.35, 0.5, 0.75>] }
      scale 2 translate -Up
    }
  }
  light_source { Key rgb <0.85, 0.76, 0.63> area_light Size * x, Size * y, 8, 8 circular orient jitter }
#end
