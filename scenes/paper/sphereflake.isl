// Haines' sphereflake, blended: nine smaller flakes on every ball, all of them one implicit surface.
//
//   isl render scenes/paper/sphereflake.isl                      three generations, 820 balls
//   isl render scenes/paper/sphereflake.isl -D Levels=4          7381 balls
//   isl render scenes/paper/sphereflake.isl -D Hardness=8        harder balls, narrower necks between them
//   isl render scenes/paper/sphereflake.isl -D Kernel=quartic    another kernel
//   isl render scenes/paper/sphereflake.isl -D Floor=1           on a floor, as in the Standard Procedural Databases
//
// After E. Haines, "A Proposal for Standard Graphics Environments", IEEE CG&A 7(11), 1987. Up is z there, and the world
// is right-handed: the camera's `right` is negative.
#version 3.7;
global_settings { assumed_gamma 1 }

#ifndef (Levels) #declare Levels = 3; #end
#ifndef (Kernel) #declare Kernel = "gaussian"; #end
#ifndef (Hardness) #declare Hardness = 4; #end
#ifndef (Floor) #declare Floor = 0; #end

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

// Deeper generations are lighter.
#declare Skins = array[Levels + 1]
#for (I, 0, Levels)
  #declare Light = 1 - pow(0.7, I + 1);
  #declare Skins[I] = texture {
    pigment { rgb <Light, Light, 1> }
    finish { ambient 0.1 diffuse 0.5 specular 0.5 roughness 0.02 }
  }
#end

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
  sphere { Centre, Radius texture { Skins[Level] } }
  #if (Level < Levels)
    #for (I, 0, 8)
      #local Child = Turned(Directions[I], Direction);
      Flake(Centre + Child * (Radius * 4 / 3), Radius / 3, Child, Level + 1)
    #end
  #end
#end

blob {
  kernel Kernel hardness Hardness
  Flake(<0, 0, 0>, 0.5, z, 0)
}

// ---- The view of the Standard Procedural Databases -----------------------------------------------------------------------

// 45° from top to bottom, whatever the image's width.
#declare Aspect = image_width / image_height;
camera {
  location <2.1, 1.3, 1.7>
  sky z
  right -x * Aspect
  angle 2 * degrees(atan(Aspect * tan(radians(45 / 2))))
  look_at 0
}

#ifdef (Soft)
  #include "../soft_studio.isl"
  Soft_studio(<4, 3, 2>, 2, z, 3)
#else
  background { rgb <0.078, 0.361, 0.753> }
  light_source { <4, 3, 2>, 0.7 }
  light_source { <1, -4, 4>, 0.7 }
  light_source { <-3, 1, 5>, 0.7 }
#end

#if (Floor)
  plane { z, -0.5 pigment { rgb <1, 0.75, 0.33> } finish { ambient 0.1 diffuse 0.9 } }
#end
