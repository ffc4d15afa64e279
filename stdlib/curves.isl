// Limbs along smooth curves: a curve through points with a radius at each, as components of a blob and as solids.
//
//   #include "curves.isl"
//   #declare Arm = array[3] { <-1, 0, 0, 0.3>, <0, 0.8, 0, 0.2>, <1, 0, 0, 0.05> }
//   blob { kernel "quartic" hardness 3 convolution on Curve_limb(Arm, 20) }
//
// A curve is an array of vectors of four terms: the place, and the radius there. It passes through all of them
// (Catmull and Rom 1974). Where the last place is the first one again, the curve is closed and smooth there too.
#ifndef (Curves_Isl_Before)
#declare Curves_Isl_Before = version;
#version 3.7;

// ---- Points of a curve ----------------------------------------------------------------------------------------------

// Curve_place(Point)
// The place of a point of a curve, without its radius.
// Point: a vector of four terms.
// Example: #declare P = <0.5, 0, 0, 0.3>; sphere { Curve_place(P), P.t pigment { rgb 1 } }
#macro Curve_place(Point) <Point.x, Point.y, Point.z> #end

// Curve_hermite_at(A, LeaveA, B, ArriveB, T)
// A point of the cubic curve between two points with given directions (Hermite's).
// A, B: the ends, vectors of three terms or four. LeaveA, ArriveB: how fast the curve leaves A and arrives at B;
// lengths of about the distance of the ends make an even curve. T: 0 (at A) to 1 (at B).
// Example: #for (I, 0, 20) sphere { Curve_hermite_at(-x, 3*y, x, 3*y, I/20), 0.06 pigment { rgb 1 } } #end
#macro Curve_hermite_at(A, LeaveA, B, ArriveB, T)
  #local Curve_Q = 1 - T;
  (Curve_Q*Curve_Q*((1 + 2*T)*A + T*LeaveA) + T*T*((1 + 2*Curve_Q)*B - Curve_Q*ArriveB))
#end

// Curve_slope(Points, I)
// The direction of a curve at its point I, as long as the curve is fast there: half the way between the points on both
// sides.
// Points: a curve of two points or more. I: 0 to the number of points less 1.
// Example: #declare C = array[3] { -x, y, x } cylinder { C[1], C[1] + Curve_slope(C, 1), 0.1 pigment { rgb 1 } }
#macro Curve_slope(Points, I)
  #local Curve_Last = dimension_size(Points, 1) - 1;
  #if (I > 0 & I < Curve_Last)
    #local Curve_S = (Points[I + 1] - Points[I - 1])/2;
  #else
    #if (vlength(Curve_place(Points[0]) - Curve_place(Points[Curve_Last])) < 1e-9 & Curve_Last > 1)
      #local Curve_S = (Points[1] - Points[Curve_Last - 1])/2;
    #else
      // An open end: the parabola through the last three points.
      #if (Curve_Last = 1)
        #local Curve_S = Points[1] - Points[0];
      #else
        #if (I = 0)
          #local Curve_S = 2*Points[1] - 1.5*Points[0] - 0.5*Points[2];
        #else
          #local Curve_S = 1.5*Points[I] + 0.5*Points[I - 2] - 2*Points[I - 1];
        #end
      #end
    #end
  #end
  (Curve_S)
#end

// Curve_at(Points, T)
// A point of the smooth curve through given points (Catmull and Rom), with its radius if they have one.
// Points: a curve. T: 0 (the first point) to 1 (the last one); each stretch between two points takes the same share.
// Example: #declare C = array[4] { -x, y/2, -y/2, x } #for (I, 0, 9) sphere { Curve_at(C, I/9), 0.1 } #end
#macro Curve_at(Points, T)
  #local Curve_Pieces = dimension_size(Points, 1) - 1;
  #local Curve_I = max(0, min(Curve_Pieces - 1, floor(T*Curve_Pieces)));
  #local Curve_T = max(0, min(1, T*Curve_Pieces - Curve_I));
  Curve_hermite_at(Points[Curve_I], Curve_slope(Points, Curve_I), Points[Curve_I + 1], Curve_slope(Points, Curve_I + 1),
                   Curve_T)
#end

// ---- Curves made of curves ------------------------------------------------------------------------------------------

// Curve_resample(Points, Pieces)
// The same curve as an array of points at equal distances along it.
// Points: a curve. Pieces: the number of stretches of the new one, which has one point more; 10 to 50 for a limb.
// Example: #declare C = array[3] {-x, y, x} #declare D = Curve_resample(C, 9); #for (I, 0, 9) sphere { D[I], .1 } #end
#macro Curve_resample(Points, Pieces)
  #local Curve_Fine = 16*(dimension_size(Points, 1) - 1);
  #local Curve_Path = array[Curve_Fine + 1];
  #local Curve_Way = array[Curve_Fine + 1];
  #local Curve_Path[0] = Points[0];
  #local Curve_Way[0] = 0;
  #for (J, 1, Curve_Fine)
    #local Curve_Path[J] = Curve_at(Points, J/Curve_Fine);
    #local Curve_Way[J] = Curve_Way[J - 1] + vlength(Curve_place(Curve_Path[J]) - Curve_place(Curve_Path[J - 1]));
  #end
  #local Curve_New = array[Pieces + 1];
  #local Curve_J = 1;
  #for (K, 0, Pieces)
    #local Curve_Goal = Curve_Way[Curve_Fine]*K/Pieces;
    #while (Curve_J < Curve_Fine & Curve_Way[Curve_J] < Curve_Goal)
      #local Curve_J = Curve_J + 1;
    #end
    #local Curve_Step = max(Curve_Way[Curve_J] - Curve_Way[Curve_J - 1], 1e-12);
    #local Curve_Share = min(1, (Curve_Goal - Curve_Way[Curve_J - 1])/Curve_Step);
    #local Curve_New[K] = Curve_at(Points, (Curve_J - 1 + Curve_Share)/Curve_Fine);
  #end
  Curve_New
#end

// Curve_length(Points)
// The length of a curve.
// Points: a curve.
// Example: #declare C = array[3] { -x, y, x } sphere { 0, Curve_length(C)/4 pigment { rgb 1 } }
#macro Curve_length(Points)
  #local Curve_Fine = 16*(dimension_size(Points, 1) - 1);
  #local Curve_Sum = 0;
  #local Curve_Before = Points[0];
  #for (J, 1, Curve_Fine)
    #local Curve_Here = Curve_at(Points, J/Curve_Fine);
    #local Curve_Sum = Curve_Sum + vlength(Curve_place(Curve_Here) - Curve_place(Curve_Before));
    #local Curve_Before = Curve_Here;
  #end
  (Curve_Sum)
#end

// Curve_hermite(A, RadiusA, LeaveA, B, RadiusB, ArriveB, Pieces)
// A curve between two places with given directions, its radius going evenly from one end to the other.
// A, B: places. RadiusA, RadiusB: radii there. LeaveA, ArriveB: as those of Curve_hermite_at. Pieces: stretches,
// usually 8.
// Example: #declare C = Curve_hermite(-x, 0.3, 3*y, x, 0.05, 2*y, 8); union { Curve_tube(C, 24) pigment { rgb 1 } }
#macro Curve_hermite(A, RadiusA, LeaveA, B, RadiusB, ArriveB, Pieces)
  #local Curve_New = array[Pieces + 1];
  #for (J, 0, Pieces)
    #local Curve_P = Curve_hermite_at(A, LeaveA, B, ArriveB, J/Pieces);
    #local Curve_New[J] = <Curve_P.x, Curve_P.y, Curve_P.z, RadiusA + (RadiusB - RadiusA)*J/Pieces>;
  #end
  Curve_New
#end

// Curve_spiral(Radius, EndRadius, Height, Turns, Thickness, EndThickness, Pieces)
// A curve that winds about the y axis, from the ground up: a spring, a horn, a tendril.
// Radius, EndRadius: of the winding, below and above. Height: of the whole. Turns: how often it goes round, negative
// for the other way. Thickness, EndThickness: the limb's radii. Pieces: stretches, about 8 a turn.
// Example: #declare C = Curve_spiral(0.8, 0.2, 1, 3, 0.15, 0.04, 24); union { Curve_tube(C, 60) pigment { rgb 1 } }
#macro Curve_spiral(Radius, EndRadius, Height, Turns, Thickness, EndThickness, Pieces)
  #local Curve_New = array[Pieces + 1];
  #for (J, 0, Pieces)
    #local Curve_T = J/Pieces;
    #local Curve_R = Radius + (EndRadius - Radius)*Curve_T;
    #local Curve_A = 2*pi*Turns*Curve_T;
    #local Curve_Thick = Thickness + (EndThickness - Thickness)*Curve_T;
    #local Curve_New[J] = <Curve_R*cos(Curve_A), Height*Curve_T, Curve_R*sin(Curve_A), Curve_Thick>;
  #end
  Curve_New
#end

// Curve_knot(P, Q, Radius, Tube, Thickness)
// A closed curve that winds P times about the y axis and Q times around the ring about it: the torus knot (P, Q).
// P, Q: whole numbers without a common divisor, as 2 and 3 (a trefoil). Radius: of the ring. Tube: how far from the
// ring's middle line.
// Thickness: of the limb.
// Example: #declare C = Curve_knot(2, 3, 0.8, 0.35, 0.12); blob { kernel "quartic" convolution on Curve_limb(C, 90) }
#macro Curve_knot(P, Q, Radius, Tube, Thickness)
  #local Curve_Count = 12*max(P, Q);
  #local Curve_New = array[Curve_Count + 1];
  #for (J, 0, Curve_Count)
    #local Curve_A = 2*pi*P*J/Curve_Count;
    #local Curve_B = 2*pi*Q*J/Curve_Count;
    #local Curve_R = Radius + Tube*cos(Curve_B);
    #local Curve_New[J] = <Curve_R*cos(Curve_A), Tube*sin(Curve_B), Curve_R*sin(Curve_A), Thickness>;
  #end
  Curve_New
#end

// Curve_wobble(Points, Amount, Stream)
// The same curve with its inner points pushed about, so that a limb looks grown.
// Points: a curve. Amount: the greatest push along each axis, usually half the limb's radius. Stream: a stream of
// `seed`.
// Example: #declare C = Curve_wobble(Curve_spiral(1, 1, 1, 2, 0.1, 0.1, 9), 0.2, seed(1)); union { Curve_tube(C, 9) }
#macro Curve_wobble(Points, Amount, Stream)
  #local Curve_New = Points;
  #for (J, 1, dimension_size(Points, 1) - 2)
    #local Curve_New[J] = Points[J] + Amount*<2*rand(Stream) - 1, 2*rand(Stream) - 1, 2*rand(Stream) - 1, 0>;
  #end
  Curve_New
#end

// ---- Limbs ----------------------------------------------------------------------------------------------------------

// Curve_paint(Share)
// What every piece of a limb has after its geometry: nothing. Declare a macro of this name after the include to paint
// along the curve; whatever a component or a solid takes may stand in it. The parameters of the macro that calls it
// are visible in it, so that names of yours like Points or Pieces mean those.
// Share: of the way along the curve, 0 to 1.
// Example: #macro Curve_paint(S) pigment { rgb <1, S, 0> } #end union { Curve_tube(array[2] { -x + t/3, x + t/9 }, 9) }
#macro Curve_paint(Share) #end

// Curve_limb(Points, Pieces)
// A limb along a curve as segments of a blob, to stand behind `convolution on`, which makes one smooth surface of
// them, without bulges where they meet. Beyond its ends it reaches less than a ball would: 0.6 radii with a hardness of
// 3, 0.8 with 8, 0.1 with 1.
// Points: a curve with radii, which should not change faster than the limb is thick. Pieces: the number of segments,
// so that each is about as long as the limb is thick.
// Example: #declare C = array[3] {t/3 - x, y + t/4, x + t/9} blob { kernel "cauchy" convolution on Curve_limb(C, 20) }
#macro Curve_limb(Points, Pieces)
  #local Curve_Even = Curve_resample(Points, Pieces);
  #for (K, 1, Pieces)
    cylinder {
      Curve_place(Curve_Even[K - 1]), Curve_place(Curve_Even[K]), (Curve_Even[K - 1].t + Curve_Even[K].t)/2
      Curve_paint((K - 0.5)/Pieces)
    }
  #end
#end

// Curve_beads(Points, Hardness)
// A limb along a curve as a row of balls of a blob, for any kernel without convolution: as close together and as
// strong as makes the surface that of a smooth limb with the curve's radii.
// Points: a curve with radii, which may change fast. Hardness: that of the kernel in force, 4 if none was said.
// Example: #declare C = array[3] { -x + t/3, y/2 + t/5, x + t/9 } blob { kernel "gaussian" Curve_beads(C, 4) }
#macro Curve_beads(Points, Hardness)
  // On a straight limb of radius r, balls c r/√h apart sum up to √π/c of one ball (Gaussian) or 1.51/c
  // (quartic), which a strength of 0.9 at c = 1.5 makes 1; their ripples are below a hundredth.
  #local Curve_Fine = 200*(dimension_size(Points, 1) - 1);
  #local Curve_Before = Points[0];
  #local Curve_Due = 0;
  #for (J, 0, Curve_Fine)
    #local Curve_Here = Curve_at(Points, J/Curve_Fine);
    #local Curve_Step = 1.5*(Curve_Here.t)/sqrt(Hardness);
    #local Curve_Due = Curve_Due - vlength(Curve_place(Curve_Here) - Curve_place(Curve_Before))/Curve_Step;
    #if (Curve_Due <= 0)
      sphere { Curve_place(Curve_Here), Curve_Here.t strength 0.9 Curve_paint(J/Curve_Fine) }
      #local Curve_Due = Curve_Due + 1;
    #end
    #local Curve_Before = Curve_Here;
  #end
#end

// Curve_cones(Points, Pieces)
// A limb along a curve as tapered cones. In a blob they bulge where they meet, unless they stand in a `union` of their
// own, which takes the greatest of them: so a limb melts into the blob around it and not into itself.
// Points: a curve with radii. Pieces: the number of cones, usually 10; a blob's unions can have 4096 combinations.
// Example: blob { kernel "gaussian" hardness 9 Curve_cones(array[3] {t/3 - x, y + t/5, x + t/9}, 9) }
#macro Curve_cones(Points, Pieces)
  #local Curve_Even = Curve_resample(Points, Pieces);
  #for (K, 1, Pieces)
    cone {
      Curve_place(Curve_Even[K - 1]), Curve_Even[K - 1].t, Curve_place(Curve_Even[K]), Curve_Even[K].t
      Curve_paint((K - 0.5)/Pieces)
    }
  #end
#end

// Curve_round_cone(A, RadiusA, B, RadiusB, Share)
// A solid limb: the ball at B, and the cone that touches it and the ball at A. In a blob, `cone` is that by itself.
// A, B: places. RadiusA, RadiusB: radii of the balls. Share: what Curve_paint gets, usually 0.
// Example: sphere { -x, 0.5 pigment { rgb 1 } } union { Curve_round_cone(-x, 0.5, x, 0.2, 0) pigment { rgb 1 } }
#macro Curve_round_cone(A, RadiusA, B, RadiusB, Share)
  sphere { B, RadiusB Curve_paint(Share) }
  #local Curve_D = vlength(B - A);
  #if (Curve_D > abs(RadiusA - RadiusB))
    // The circles at which the cone touches the balls are that far up the axis, in units of the radius.
    #local Curve_Up = (RadiusA - RadiusB)/Curve_D;
    #local Curve_Axis = (B - A)/Curve_D;
    #local Curve_Width = sqrt(1 - Curve_Up*Curve_Up);
    cone {
      A + RadiusA*Curve_Up*Curve_Axis, RadiusA*Curve_Width, B + RadiusB*Curve_Up*Curve_Axis, RadiusB*Curve_Width open
      Curve_paint(Share)
    }
  #end
#end

// Curve_tube(Points, Pieces)
// A limb along a curve as solids, for a `union` or a `merge`: balls, and cones that touch them.
// Points: a curve with radii. Pieces: the number of cones, 20 to 60.
// Example: #declare C = array[3] { -x + t/3, y/2 + t/5, x + t/9 } union { Curve_tube(C, 30) pigment { rgb 1 } }
#macro Curve_tube(Points, Pieces)
  #local Curve_Even = Curve_resample(Points, Pieces);
  sphere { Curve_place(Curve_Even[0]), Curve_Even[0].t Curve_paint(0) }
  #for (K, 1, Pieces)
    Curve_round_cone(Curve_place(Curve_Even[K - 1]), Curve_Even[K - 1].t, Curve_place(Curve_Even[K]), Curve_Even[K].t,
                     K/Pieces)
  #end
#end

#version Curves_Isl_Before;
#end
