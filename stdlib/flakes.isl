// Flakes: balls that bear smaller balls, which bear smaller ones, as components of a blob of any kernel and as solids.
//
//   #include "flakes.isl"
//   blob { kernel "gaussian" hardness 4 Flake_sphere(0, 1, y, 9, 1/3, 1, 3) }
//   union { Flake_sphere(0, 1, y, 9, 1/3, 1, 3) }
//
// In a blob with a kernel, radii are those of the surface; the kernel and its hardness are the caller's. The number of
// balls is that of Flake_count: one generation too many can be millions.
#ifndef (Flakes_Isl_Before)
#declare Flakes_Isl_Before = version;
#version 3.7;
#include "math.inc"

// Flake_paint(Level)
// What every ball has after its centre and radius: nothing. Declare a macro of this name after the include to paint by
// generations; in a blob it may begin with a `strength`. The parameters of the macro that calls it are visible in it,
// so that names of yours like Radius, Axis or Depth mean those.
// Level: the generation, from 0.
// Example: #macro Flake_paint(L) pigment { rgb <1, L/3, 0> } #end union { Flake_sphere(0, 0.6, y, 9, 1/3, 1, 3) }
#macro Flake_paint(Level) #end

// Flake_ball(Centre, Radius, Axis, Level)
// What stands at each place of a flake: a ball. Declare a macro of this name after the include to have something else
// there.
// Centre: its place. Radius: half its size. Axis: its direction away from its parent, of length 1. Level: its
// generation, from 0.
// Example: #macro Flake_ball(C, R, A, L) cone { C, R, C + R*A, 0 } #end union { Flake_sphere(0, 0.6, y, 9, 1/3, 1, 2) }
#macro Flake_ball(Centre, Radius, Axis, Level)
  sphere { Centre, Radius Flake_paint(Level) }
#end

// Flake_count(Children, Depth)
// The number of balls of a flake.
// Children: of every ball. Depth: generations after the first ball.
// Example: sphere { 0, Flake_count(9, 3)/820 pigment { rgb 1 } }
#macro Flake_count(Children, Depth)
  #local Flake_Sum = 0;
  #for (J, 0, Depth)
    #local Flake_Sum = Flake_Sum + pow(Children, J);
  #end
  (Flake_Sum)
#end

// Flake_cap(Count, Spread)
// An array of directions, evenly spread by the golden angle over a cap about y: where the children of a ball stand.
// Count: how many. Spread: the cap's half angle in degrees; 90 is half the sphere, 110 leaves room for the parent, 180
// is all of it.
// Example: #declare D = Flake_cap(40, 90); #for (I, 0, 39) sphere { D[I], 0.08 pigment { rgb 1 } } #end
#macro Flake_cap(Count, Spread)
  #local Flake_D = array[Count];
  #for (J, 0, Count - 1)
    #local Flake_H = 1 - (J + 0.5)/Count*(1 - cos(radians(Spread)));
    #local Flake_A = pi*(3 - sqrt(5))*J;
    #local Flake_W = sqrt(max(1 - Flake_H*Flake_H, 0));
    #local Flake_D[J] = <Flake_W*cos(Flake_A), Flake_H, Flake_W*sin(Flake_A)>;
  #end
  Flake_D
#end

// Flake_haines()
// The nine directions of the sphere-flake of E. Haines' Standard Procedural Databases (1987), about y: six around,
// three above.
// Example: union { Flake_of(0, 0.6, y, Flake_haines(), 1/3, 1, 3) pigment { rgb 1 } }
#macro Flake_haines()
  #local Flake_D = array[9];
  #for (J, 0, 5)
    #local Flake_D[J] = vrotate(x, (15 + 60*J)*y);
  #end
  #for (J, 0, 2)
    #local Flake_D[6 + J] = vrotate(vrotate(x, degrees(asin(sqrt(2/3)))*z), (45 + 120*J)*y);
  #end
  Flake_D
#end

// Flake_cross(Parts)
// The five directions that are at right angles to a ball's parent or away from it, for flakes in which cubes hide.
// Parts: 5, or 4 for flat ones without the one that goes on.
// Example: union { Flake_of(0, 0.5, y, Flake_cross(5), 0.5, 1, 4) pigment { rgb 1 } }
#macro Flake_cross(Parts)
  #local Flake_D = array[Parts];
  #for (J, 0, 3)
    #local Flake_D[J] = vrotate(x, 90*J*y);
  #end
  #if (Parts > 4)
    #local Flake_D[4] = y;
  #end
  Flake_D
#end

// Flake_of(Centre, Radius, Axis, Directions, Ratio, Reach, Depth)
// A flake whose balls bear children in given directions.
// Centre, Radius: the first ball. Axis: where it points. Directions: an array of directions about y, which are turned
// with each ball; see Flake_cap. Ratio: a child's radius as a share of its parent's, usually 1/3 to 1/2. Reach: 1
// where parent and child touch, below 1 where they overlap, usually 0.8 to 1. Depth: generations after the first ball,
// usually 3.
// Example: union { Flake_of(-y/2, 0.5, y, Flake_cap(5, 90), 0.45, 0.9, 4) pigment { rgb 1 } }
#macro Flake_of(Centre, Radius, Axis, Directions, Ratio, Reach, Depth)
  Flake_grow(Centre, Radius, vnormalize(Axis), VPerp_To_Vector(Axis), Directions, Ratio, Reach, Depth, 0)
#end

// Flake_grow(Centre, Radius, Axis, Side, Directions, Ratio, Reach, Depth, Level)
// A ball of a flake and all that grows on it; what Flake_of is made of.
// Axis, Side: two directions of length 1 at right angles, to which y and x are turned. Level: the generation of this
// ball, usually 0. The others: as those of Flake_of.
// Example: union { Flake_grow(0, 0.7, y, x, Flake_cap(7, 90), 0.3, 1, 3, 0) pigment { rgb 1 } }
#macro Flake_grow(Centre, Radius, Axis, Side, Directions, Ratio, Reach, Depth, Level)
  Flake_ball(Centre, Radius, Axis, Level)
  #if (Level < Depth)
    #local Flake_Z = vcross(Side, Axis);
    #for (Flake_J, 0, dimension_size(Directions, 1) - 1)
      #local Flake_D = Directions[Flake_J];
      #local Flake_Y = Flake_D.x*Side + Flake_D.y*Axis + Flake_D.z*Flake_Z;
      // The child's side is at right angles to the way from its parent's axis, so that neighbours are turned alike.
      #local Flake_X = vcross(Flake_Y, Axis);
      #if (vlength(Flake_X) < 1e-6)
        #local Flake_X = Side;
      #end
      Flake_grow(Centre + Radius*(1 + Ratio)*Reach*Flake_Y, Radius*Ratio, Flake_Y, vnormalize(Flake_X), Directions,
                 Ratio, Reach, Depth, Level + 1)
    #end
  #end
#end

// Flake_sphere(Centre, Radius, Axis, Children, Ratio, Reach, Depth)
// A sphere-flake with any number of children, spread evenly over the part of each ball that looks away from its
// parent. With nine children they are Haines' nine.
// Centre, Radius: the first ball. Axis: the direction of its pole. Children: of each ball, 3 to 20. Ratio, Reach,
// Depth: as those of Flake_of; 9 children have room at a Ratio of 1/3, 20 at 1/5.
// Example: blob { kernel "gaussian" hardness 4 Flake_sphere(0, 0.6, y, 9, 1/3, 1, 3) pigment { rgb <1, 0.8, 0.4> } }
#macro Flake_sphere(Centre, Radius, Axis, Children, Ratio, Reach, Depth)
  #if (Children = 9)
    #local Flake_Dirs = Flake_haines();
  #else
    #local Flake_Dirs = Flake_cap(Children, 105);
  #end
  Flake_of(Centre, Radius, Axis, Flake_Dirs, Ratio, Reach, Depth)
#end

// Flake_crystal(Centre, Radius, Normal, Depth)
// A flat snow crystal of six arms: every ball goes on and bears two side arms at 60 degrees.
// Centre: its middle. Radius: from the middle to the tips. Normal: the direction across it. Depth: 2 to 4; 3 makes
// 7,000 balls.
// Example: blob { kernel "gaussian" Flake_crystal(0, 1.2, -z, 3) pigment { rgb <0.8, 0.9, 1> } }
#macro Flake_crystal(Centre, Radius, Normal, Depth)
  #local Flake_N = vnormalize(Normal);
  Flake_ball(Centre, Radius*0.09, Flake_N, 0)
  #for (Flake_K, 0, 5)
    Flake_arm(Centre, vaxis_rotate(VPerp_To_Vector(Flake_N), Flake_N, 60*Flake_K), Flake_N, Radius, Depth, 1)
  #end
#end

// Flake_arm(Foot, Axis, Normal, Length, Depth, Level)
// One arm of a snow crystal: a row of balls that grow smaller, with smaller arms on both sides.
// Foot: where it begins. Axis: its direction. Normal: the direction across the crystal. Length: of the arm. Depth:
// generations, 3 to 5. Level: that of this arm, usually 1.
// Example: blob { kernel "gaussian" Flake_arm(-x, x, z, 2, 3, 1) pigment { rgb <0.8, 0.9, 1> } }
#macro Flake_arm(Foot, Axis, Normal, Length, Depth, Level)
  #for (Flake_J, 1, 20)
    Flake_ball(Foot + Axis*Length*Flake_J/20, Length*(0.05 - 0.001*Flake_J), Axis, Level)
  #end
  #if (Level < Depth)
    #for (Flake_J, 5, 14, 3)
      #for (Flake_Turn, -60, 60, 120)
        Flake_arm(Foot + Axis*Length*Flake_J/20, vaxis_rotate(Axis, Normal, Flake_Turn), Normal,
                  Length*(0.56 - 0.028*Flake_J), Depth, Level + 1)
      #end
    #end
  #end
#end

#version Flakes_Isl_Before;
#end
