// Light that makes form readable: a large lamp, the sky, and what surfaces throw on one another. Try
// `isl render soft_light.isl --without sky_light`, and `--max-noise 0.004` for the wall.
#version 3.7;
global_settings { assumed_gamma 1 sky_light { distance 12 } bounce_light { distance 6 } }

camera { location <0, 3.1, -7.5> look_at <0, 0.85, 0> angle 36 }
sky_sphere {
  pigment { gradient y color_map { [0.0 rgb <0.75, 0.6, 0.5>] [0.25 rgb <0.55, 0.6, 0.7>] [1 rgb <0.2, 0.35, 0.65>] } }
}
light_source { <-6, 7, -5> rgb <1.0, 0.85, 0.65> area_light <3, 0, 0>, <0, 0, 3>, 8, 8 jitter circular orient }

plane { y, 0 pigment { rgb <0.82, 0.78, 0.72> } finish { diffuse 0.75 } }

// A shell of balls that grows along a spiral and melts together.
blob {
  kernel "gaussian" hardness 3.5
  #local Turns = 46;
  #for (I, 0, Turns)
    #local Growth = pow(1.045, I);
    sphere {
      vrotate(<0.19 * Growth, 0, 0>, 27 * I * y) + (1.75 - 0.012 * I - 0.16 * Growth) * y, 0.13 * Growth
      pigment { rgb <0.95, 0.86 - 0.009 * I, 0.75 - 0.012 * I> }
    }
  #end
  translate 0.1 * y
}
sphere { <2.5, 0.55, 0.9>, 0.55 pigment { rgb <0.75, 0.15, 0.1> } }
sphere { <-2.4, 0.4, -0.6>, 0.4 pigment { rgb <0.15, 0.4, 0.5> } }
