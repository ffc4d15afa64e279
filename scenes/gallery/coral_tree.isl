// The coral tree: a branching skeleton of tapered limbs, its sixteen tips covered in needles, blended into one surface.
//
//   isl render scenes/gallery/coral_tree.isl                     the coral
//   isl render scenes/gallery/coral_tree.isl -D Skeleton=1       its skeleton: the same macro in a `union`
//   isl render scenes/gallery/coral_tree.isl -D Levels=6         more branches
//   isl render scenes/gallery/coral_tree.isl -D Ground=0         nothing below it
//
// The branching is that of the tree in E. Haines' Standard Procedural Databases (1987); the needles on its tips are in
// the manner of the coral in A. Sherstyuk, "Fast Ray Tracing of Implicit Surfaces" (1999): 31 branches and 512 needles.
#version 3.7;
global_settings { assumed_gamma 1 }

#ifndef (Levels) #declare Levels = 4; #end
#ifndef (Needles) #declare Needles = 32; #end
#ifndef (Skeleton) #declare Skeleton = 0; #end
#ifndef (Ground) #declare Ground = 1; #end

// From deep red at the foot to rose at the tips, and pale needles.
#declare Foot = srgb <0.84, 0.27, 0.25>;
#declare Tip = srgb <1.00, 0.66, 0.54>;
#declare Bark = array[Levels + 1]
#for (I, 0, Levels)
  #declare Bark[I] = texture {
    pigment { color Foot + (Tip - Foot) * pow(I / max(Levels, 1), 0.8) }
    finish { ambient 0.24 diffuse 0.64 specular 0.25 roughness 0.04 }
  }
#end
#declare Thorn = texture {
  pigment { color srgb <1.00, 0.84, 0.76> }
  finish { ambient 0.34 diffuse 0.60 specular 0.22 roughness 0.04 }
}

// V, given along the axes U, W and Axis.
#macro Along(V, U, W, Axis) (V.x * U + V.y * W + V.z * Axis) #end

// A branch from At along Axis; from its end grow two more, by Haines' angles and shrinking. The last branches bear thin
// cones all round their ends, evenly spread by the golden angle over a little more than a hemisphere.
#macro Branch(At, U, W, Axis, Length, Width, Level)
  #local End = At + Axis * Length;
  cone { At, Width, End, Width * 0.67 texture { Bark[Level] } }
  #if (Level < Levels)
    Sprout(0.65, 40, 90)
    Sprout(0.70, 25, 230)
  #else
    #for (I, 0, Needles - 1)
      #local Height = 1 - 1.35 * (I + 0.5) / Needles;
      #local Turn = radians(137.50776 * I);
      #local Spread = sqrt(1 - Height * Height);
      #local Direction = Along(<Spread * cos(Turn), Spread * sin(Turn), Height>, U, W, Axis);
      cone { End, Width * 0.42, End + Direction * Length * 0.85, Width * 0.42 * 0.3 texture { Thorn } }
    #end
  #end
#end

// The next branch from the end of the one that calls it: shorter, bent away from it and turned about it.
#macro Sprout(Share, Bend, Turn)
  #local NewU = Along(vrotate(vrotate(x, Bend * x), Turn * z), U, W, Axis);
  #local NewW = Along(vrotate(vrotate(y, Bend * x), Turn * z), U, W, Axis);
  #local NewAxis = Along(vrotate(vrotate(z, Bend * x), Turn * z), U, W, Axis);
  Branch(End, NewU, NewW, NewAxis, Length * Share, Width * 0.67, Level + 1)
#end

#macro Coral() Branch(<0, -0.5, 0>, x, z, y, 1, 0.19, 0) #end
#if (Skeleton) union { Coral() } #else blob { kernel "gaussian" hardness 3 Coral() } #end

#if (Ground)
  plane { y, 0 pigment { color srgb <0.95, 0.91, 0.85> } finish { ambient 0.42 diffuse 0.55 } }
#end
#ifdef (Soft)
  #include "../soft_studio.isl"
  Soft_studio(<-5, 8, -6>, 3, y, 6)
#else
  light_source { <-5, 8, -6>, srgb <1.0, 0.96, 0.90> }
  light_source { <7, 5, -4>, srgb <0.80, 0.88, 1.0> * 0.35 shadowless }
#end
camera { location <1.0, 3.25, -6.0> right x * image_width / image_height angle 34 look_at <0.36, 1.06, 0> }
