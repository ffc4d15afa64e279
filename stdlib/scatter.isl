// Places for many things: on any object, along a curve, and spread so that no two are close.
//
//   #include "scatter.isl"
//   #declare Stone = blob { kernel "gaussian" sphere { 0, 1 } sphere { 0.8*x, 0.6 } }
//   #declare Spots = Scatter_on(Stone, 200, seed(1));
//   Stone
//   #for (I, 0, 199) sphere { Spots[I][0], 0.05 } #end
//
// The macros give arrays. Places on a surface come with the normal there, which turns things upright: Point_At_Trans
// of transforms.inc takes y to it.
#ifndef (Scatter_Isl_Before)
#declare Scatter_Isl_Before = version;
#version 3.7;
#include "transforms.inc"
#include "curves.isl"

// ---- On surfaces ----------------------------------------------------------------------------------------------------

// Scatter_on(Object, Count, Stream)
// Places all over an object, found by lines in random directions: an array of Count places and normals, [I][0] and
// [I][1]. All that can be seen from outside is as likely as it is large.
// Object: any object that ends; a plane does not. Count: how many. Stream: a stream of `seed`.
// Example: #declare P = Scatter_on(torus { 0.8, 0.3 }, 200, seed(1)); #for (I, 0, 199) sphere { P[I][0], 0.05 } #end
#macro Scatter_on(Object, Count, Stream)
  #local Scatter_Low = min_extent(Object);
  #local Scatter_High = max_extent(Object);
  #local Scatter_Middle = (Scatter_Low + Scatter_High)/2;
  #local Scatter_R = vlength(Scatter_High - Scatter_Low)/2;
  #local Scatter_New = array[Count][2];
  #local Scatter_N = y;
  #local Scatter_Found = 0;
  #local Scatter_Tries = 0;
  #while (Scatter_Found < Count)
    // A random line that meets the ball around the object: a direction, and a point of the disc across it.
    #local Scatter_H = 2*rand(Stream) - 1;
    #local Scatter_A = 2*pi*rand(Stream);
    #local Scatter_W = sqrt(1 - Scatter_H*Scatter_H);
    #local Scatter_D = <Scatter_W*cos(Scatter_A), Scatter_H, Scatter_W*sin(Scatter_A)>;
    #local Scatter_Off = vaxis_rotate(VPerp_To_Vector(Scatter_D), Scatter_D, 360*rand(Stream));
    #local Scatter_From = Scatter_Middle + Scatter_R*(sqrt(rand(Stream))*Scatter_Off - 1.01*Scatter_D);
    #local Scatter_P = trace(Object, Scatter_From, Scatter_D, Scatter_N);
    #if (vlength(Scatter_N) > 0)
      #local Scatter_New[Scatter_Found][0] = Scatter_P;
      #local Scatter_New[Scatter_Found][1] = Scatter_N;
      #local Scatter_Found = Scatter_Found + 1;
    #end
    #local Scatter_Tries = Scatter_Tries + 1;
    #if (Scatter_Tries > 1000*(Count + 1))
      #error "Scatter_on: lines do not meet the object; is it empty, or without end?"
    #end
  #end
  Scatter_New
#end

// Scatter_key(Cell, Size)
// The place of a cell of space in a table; a part of Scatter_apart.
// Cell: a point, of which the whole numbers below its terms count. Size: of the table.
// Example: sphere { 0, 0.1 + Scatter_key(<3, 4, 5>, 10)/20 pigment { rgb 1 } }
#macro Scatter_key(Cell, Size)
  (mod(abs(floor(Cell.x)*7393 + floor(Cell.y)*1933 + floor(Cell.z)*8349), Size))
#end

// Scatter_apart(Spots, Distance)
// Those of the places that are farther than a distance from all that come before them: an array like the given one,
// shorter.
// Spots: places and normals, as Scatter_on gives them. Distance: the least one; it may not be 0.
// Example: #declare P = Scatter_apart(Scatter_on(sphere { 0, 1 }, 500, seed(1)), 0.3); sphere { P[0][0], 0.1 }
#macro Scatter_apart(Spots, Distance)
  // A table of cells as wide as the distance holds the places that are kept: each is compared with its neighbours.
  #local Scatter_Count = dimension_size(Spots, 1);
  #local Scatter_Size = 4*Scatter_Count + 7;
  #local Scatter_First = array[Scatter_Size];
  #local Scatter_Next = array[Scatter_Count];
  #local Scatter_Kept = 0;
  #local Scatter_Keep = array[Scatter_Count];
  #for (Scatter_I, 0, Scatter_Count - 1)
    #local Scatter_P = Spots[Scatter_I][0];
    #local Scatter_Free = yes;
    #local Scatter_Cell = Scatter_P/Distance;
    #for (Scatter_X, floor(Scatter_Cell.x) - 1, floor(Scatter_Cell.x) + 1)
      #for (Scatter_Y, floor(Scatter_Cell.y) - 1, floor(Scatter_Cell.y) + 1)
        #for (Scatter_Z, floor(Scatter_Cell.z) - 1, floor(Scatter_Cell.z) + 1)
          #local Scatter_Key = Scatter_key(<Scatter_X, Scatter_Y, Scatter_Z>, Scatter_Size);
          #if (defined(Scatter_First[Scatter_Key]))
            #local Scatter_J = Scatter_First[Scatter_Key];
            #while (Scatter_J >= 0 & Scatter_Free)
              #local Scatter_Free = (vlength(Spots[Scatter_J][0] - Scatter_P) >= Distance);
              #local Scatter_J = Scatter_Next[Scatter_J];
            #end
          #end
        #end
      #end
    #end
    #if (Scatter_Free)
      #local Scatter_Key = Scatter_key(Scatter_Cell, Scatter_Size);
      #local Scatter_Next[Scatter_I] = -1;
      #if (defined(Scatter_First[Scatter_Key]))
        #local Scatter_Next[Scatter_I] = Scatter_First[Scatter_Key];
      #end
      #local Scatter_First[Scatter_Key] = Scatter_I;
      #local Scatter_Keep[Scatter_Kept] = Scatter_I;
      #local Scatter_Kept = Scatter_Kept + 1;
    #end
  #end
  #local Scatter_New = array[Scatter_Kept][2];
  #for (Scatter_I, 0, Scatter_Kept - 1)
    #local Scatter_New[Scatter_I][0] = Spots[Scatter_Keep[Scatter_I]][0];
    #local Scatter_New[Scatter_I][1] = Spots[Scatter_Keep[Scatter_I]][1];
  #end
  Scatter_New
#end

// Scatter_drop(Object, X, Z, Normal)
// The highest point of an object above a place of the ground, for things that stand on it. Normal becomes the normal
// there, or <0, 0, 0> where there is nothing.
// Object: any object. X, Z: the place. Normal: the name of a variable that holds a vector.
// Example: #declare N = y; #declare P = Scatter_drop(sphere { 0, 1 }, 0.5, 0, N); cylinder { P, P - N, 0.2 }
#macro Scatter_drop(Object, X, Z, Normal)
  #local Scatter_Top = max_extent(Object);
  #local Scatter_P = trace(Object, <X, min(Scatter_Top.y, 1e6) + 1, Z>, -y, Normal);
  (Scatter_P)
#end

// ---- Along curves ---------------------------------------------------------------------------------------------------

// Scatter_along(Points, Count, Turn)
// Places on the surface of a limb along a curve, at equal distances: an array of places, directions outwards and
// directions along the curve, [I][0] to [I][2]. For thorns, leaves, suckers.
// Points: a curve with radii, as in curves.isl. Count: how many, at least 2. Turn: degrees round the limb from one to
// the next; 137.5 spreads evenly, 180 makes two rows, 0 one.
// Example: #declare S = Scatter_along(array[2] { t/3 - x, x }, 60, 137.5); #for (I, 0, 59) sphere { S[I][0], .1 } #end
#macro Scatter_along(Points, Count, Turn)
  #local Scatter_Even = Curve_resample(Points, Count - 1);
  #local Scatter_New = array[Count][3];
  #local Scatter_Side = VPerp_To_Vector(Curve_place(Scatter_Even[1]) - Curve_place(Scatter_Even[0]));
  #for (Scatter_I, 0, Count - 1)
    #local Scatter_Ahead = Curve_place(Scatter_Even[min(Scatter_I + 1, Count - 1)]);
    #local Scatter_D = vnormalize(Scatter_Ahead - Curve_place(Scatter_Even[max(Scatter_I - 1, 0)]));
    // The side is carried along without turning about the curve.
    #local Scatter_Side = vnormalize(Scatter_Side - vdot(Scatter_Side, Scatter_D)*Scatter_D);
    #local Scatter_Out = vaxis_rotate(Scatter_Side, Scatter_D, Turn*Scatter_I);
    #local Scatter_New[Scatter_I][0] = Curve_place(Scatter_Even[Scatter_I]) + Scatter_Even[Scatter_I].t*Scatter_Out;
    #local Scatter_New[Scatter_I][1] = Scatter_Out;
    #local Scatter_New[Scatter_I][2] = Scatter_D;
  #end
  Scatter_New
#end

// ---- Poisson discs --------------------------------------------------------------------------------------------------

// Scatter_rectangle(Width, Depth, Distance, Stream)
// Places of the ground that are random but nowhere closer than a distance, and leave no gap (Bridson 2007): an array
// of points <x, 0, z> of the rectangle from the origin.
// Width, Depth: of the rectangle, along x and z. Distance: the least one; there are about 0.7 Width Depth/Distance²
// places.
// Stream: a stream of `seed`.
// Example: #declare P = Scatter_rectangle(2, 2, 0.3, seed(1)); #for (I, 0, 9) sphere { P[I] - <1, 0, 1>, 0.1 } #end
#macro Scatter_rectangle(Width, Depth, Distance, Stream)
  #local Scatter_W = Distance/sqrt(2);
  #local Scatter_Nx = ceil(Width/Scatter_W);
  #local Scatter_Nz = ceil(Depth/Scatter_W);
  #local Scatter_Grid = array[Scatter_Nx][Scatter_Nz];
  #local Scatter_All = array[Scatter_Nx*Scatter_Nz];
  #local Scatter_Active = array[Scatter_Nx*Scatter_Nz];
  #local Scatter_P = <Width*rand(Stream), 0, Depth*rand(Stream)>;
  #local Scatter_All[0] = Scatter_P;
  #local Scatter_Grid[floor(Scatter_P.x/Scatter_W)][floor(Scatter_P.z/Scatter_W)] = Scatter_P;
  #local Scatter_Count = 1;
  #local Scatter_Active[0] = 0;
  #local Scatter_Left = 1;
  #while (Scatter_Left > 0)
    #local Scatter_Pick = min(Scatter_Left - 1, floor(Scatter_Left*rand(Stream)));
    #local Scatter_Mother = Scatter_All[Scatter_Active[Scatter_Pick]];
    #local Scatter_Free = no;
    #local Scatter_Tries = 0;
    #while (!Scatter_Free & Scatter_Tries < 20)
      #local Scatter_Tries = Scatter_Tries + 1;
      #local Scatter_A = 2*pi*rand(Stream);
      #local Scatter_P = Scatter_Mother + Distance*sqrt(1 + 3*rand(Stream))*<cos(Scatter_A), 0, sin(Scatter_A)>;
      #if (Scatter_P.x >= 0 & Scatter_P.x < Width & Scatter_P.z >= 0 & Scatter_P.z < Depth)
        #local Scatter_Free = yes;
        #local Scatter_X = floor(Scatter_P.x/Scatter_W);
        #local Scatter_Z = floor(Scatter_P.z/Scatter_W);
        #for (Scatter_I, max(0, Scatter_X - 2), min(Scatter_Nx - 1, Scatter_X + 2))
          #for (Scatter_J, max(0, Scatter_Z - 2), min(Scatter_Nz - 1, Scatter_Z + 2))
            #if (defined(Scatter_Grid[Scatter_I][Scatter_J]))
              #if (vlength(Scatter_Grid[Scatter_I][Scatter_J] - Scatter_P) < Distance)
                #local Scatter_Free = no;
              #end
            #end
          #end
        #end
      #end
    #end
    #if (Scatter_Free)
      #local Scatter_Grid[Scatter_X][Scatter_Z] = Scatter_P;
      #local Scatter_All[Scatter_Count] = Scatter_P;
      #local Scatter_Active[Scatter_Left] = Scatter_Count;
      #local Scatter_Count = Scatter_Count + 1;
      #local Scatter_Left = Scatter_Left + 1;
    #else
      #local Scatter_Left = Scatter_Left - 1;
      #local Scatter_Active[Scatter_Pick] = Scatter_Active[Scatter_Left];
    #end
  #end
  #local Scatter_New = array[Scatter_Count];
  #for (Scatter_I, 0, Scatter_Count - 1)
    #local Scatter_New[Scatter_I] = Scatter_All[Scatter_I];
  #end
  Scatter_New
#end

// Scatter_disc(Radius, Distance, Stream)
// The same on a disc about the origin.
// Radius: of the disc. Distance: the least one; there are about 2.2 (Radius/Distance)² places. Stream: a stream of
// `seed`.
// Example: #declare P = Scatter_disc(1, 0.15, seed(1)); #for (I, 0, 59) sphere { P[I], 0.07 pigment { rgb 1 } } #end
#macro Scatter_disc(Radius, Distance, Stream)
  #local Scatter_Square = Scatter_rectangle(2*Radius, 2*Radius, Distance, Stream);
  #local Scatter_All = array[dimension_size(Scatter_Square, 1)];
  #local Scatter_Count = 0;
  #for (Scatter_I, 0, dimension_size(Scatter_Square, 1) - 1)
    #local Scatter_P = Scatter_Square[Scatter_I] - Radius*<1, 0, 1>;
    #if (vlength(Scatter_P) <= Radius)
      #local Scatter_All[Scatter_Count] = Scatter_P;
      #local Scatter_Count = Scatter_Count + 1;
    #end
  #end
  #local Scatter_New = array[max(Scatter_Count, 1)];
  #local Scatter_New[0] = <0, 0, 0>;
  #for (Scatter_I, 0, Scatter_Count - 1)
    #local Scatter_New[Scatter_I] = Scatter_All[Scatter_I];
  #end
  Scatter_New
#end

#version Scatter_Isl_Before;
#end
