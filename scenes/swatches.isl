// One material on a test body: a blend of balls and a bent limb, large and small, turned up and down, on a floor with
// stripes that glass can bend, in a studio.
//
//   bench/swatches.py                     renders a page of all materials of the libraries
//
// A scene that declares Material (a material) and includes this file shows that material:
//   #include "metals.isl"
//   #declare Material = material { texture { PolishedGold } }
//   #include "swatches.isl"
// -D Light=0 takes point lights, -D Light=1 soft ones, and without it there is light from all around, too.
#version 3.7;
#include "lights.isl"
#include "cameras.isl"
#include "finishes.isl"
global_settings { assumed_gamma 1 max_trace_level 12 }

#ifndef (Light) #declare Light = 2; #end
#ifndef (Material) #declare Material = material { texture { pigment { rgb 0.6 } finish { SatinFinish } } } #end

#declare Body = blob {
  kernel "gaussian" hardness 3
  sphere { <0, 0.78, 0>, 0.7 }
  sphere { <0.66, 0.38, -0.45>, 0.36 }
  sphere { <0.02, 1.5, 0.02>, 0.33 }
  cylinder { <-0.45, 0.5, -0.15>, <-0.98, 0.25, -0.4>, 0.23 }
  cylinder { <-0.98, 0.25, -0.4>, <-1.12, 0.86, -0.25>, 0.15 }
  sphere { <-1.12, 1.06, -0.22>, 0.22 }
  sphere { <0.36, 1.66, -0.08>, 0.13 }
}

#macro Dressed(Thing)
  object { Thing material { Material } }
#end

Dressed(Body)

// Stripes to be bent, fading into an even grey far away.
plane { y, 0
  pigment {
    cylindrical
    pigment_map {
      [0 rgb 0.32]
      [0.6 gradient x color_map { [0.5 rgb 0.25] [0.5 rgb 0.39] } scale 0.06 rotate 30*y]
    }
    scale 6
  }
  finish { ambient 0.08 diffuse 0.8 }
}

#declare View = <0.2, 0.5, -1>;
#switch (Light)
  #case (0)
    StudioLights(Body, View)
    sky_sphere { StudioSky }
  #break
  #case (1)
    SoftStudioLights(Body, View)
    sky_sphere { StudioSky }
  #break
  #else
    SoftStudio(Body, View)
#end
PlacedCamera(Body, View, 26, 0.96, <0.01, -0.02>)
