// The scene that both programs read, unchanged, when isl is compared with POV-Ray 3.7: Haines' sphereflake as one blob.
// It uses only what the two share; scenes/paper/sphereflake.isl is the same flake with the kernels that isl adds.
//
//   isl render bench/scenes/flake.pov -D Levels=4               7,381 components
//   povray bench/scenes/flake.pov Declare=Levels=4 +W800 +H600
//
// Levels = 0…6 gives 1, 10, 91, 820, 7,381, 66,430 and 597,871 components.
//
// After E. Haines, "A Proposal for Standard Graphics Environments", IEEE CG&A 7(11), 1987. Up is z there, and the world
// is right-handed: the camera's `right` is negative.
#version 3.7;
global_settings { assumed_gamma 1 }

#ifndef (Levels) #declare Levels = 3; #end

// ---- A ball's field --------------------------------------------------------------------------------------------------
// POV-Ray's component is Strength * (1 - (d / Support)^2)^2 within distance Support of the centre. With these two numbers
// it has the value 1, the threshold, at distance Radius, and hardness 4 there: `kernel "quartic" hardness 4` in isl's words.
#declare Strength = 9;
#declare Support_per_radius = sqrt(1.5);

// ---- The nine directions in which a ball that points to +z bears children -----------------------------------------
#declare Directions = array[9]
#for (I, 0, 5)  // six around the equator
  #declare Directions[I] = vrotate(x, (15 + 60 * I) * z);
#end
#declare Elevation = degrees(asin(sqrt(2 / 3)));
#for (I, 0, 2)  // and three on top
  #declare Directions[6 + I] = vrotate(x, <0, -Elevation, 45 + 120 * I>);
#end

// ---- One ball and all that grows on it -------------------------------------------------------------------------------

// V, turned as +z would be turned to point along Direction.
#macro Turned(V, Direction)
  #if (Direction.z >= 0.9999)
    V
  #else
    #if (Direction.z <= -0.9999)
      (V * <-1, 1, -1>)
    #else
      vaxis_rotate(V, <-Direction.y, Direction.x, 0>, degrees(acos(Direction.z)))
    #end
  #end
#end

#macro Flake(Centre, Radius, Direction, Level)
  sphere { Centre, Radius * Support_per_radius, Strength }
  #if (Level < Levels)
    #for (I, 0, 8)
      #local Child = (Turned(Directions[I], Direction));  // POV-Ray wants the brackets: the value ends inside an #if
      Flake(Centre + Child * (Radius * 4 / 3), Radius / 3, Child, Level + 1)
    #end
  #end
#end

blob {
  threshold 1
  Flake(<0, 0, 0>, 0.5, z, 0)
  pigment { rgb <0.6, 0.6, 1> }
  finish { ambient 0.1 diffuse 0.5 specular 0.5 roughness 0.02 }
}

// ---- The view of the Standard Procedural Databases -------------------------------------------------------------------

// 45° from top to bottom, whatever the image's width.
#declare Aspect = image_width / image_height;
camera {
  location <2.1, 1.3, 1.7>
  sky z
  right -x * Aspect
  angle 2 * degrees(atan(Aspect * tan(radians(45 / 2))))
  look_at 0
}

background { rgb <0.078, 0.361, 0.753> }
light_source { <4, 3, 2>, 0.7 }
light_source { <1, -4, 4>, 0.7 }
