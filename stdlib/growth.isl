// Living growth: places by phyllotaxis, spines, ribs, spirals, holes and ruffles; urchins, cacti, shells, sponges,
// lettuce corals.
//
//   #include "growth.isl"
//   blob { kernel "gaussian" hardness 5 Growth_urchin(0, 0.6, 300, 0.6, 0.03, seed(1)) }
//
// What makes whole things leaves components of a blob of any kernel, or solids of a union; the places serve
// everything.
#ifndef (Growth_Isl_Before)
#declare Growth_Isl_Before = version;
#version 3.7;
#include "math.inc"

// Growth_Angle: number. The golden angle, in degrees: each leaf stands that far round from the one before.
#declare Growth_Angle = 180*(3 - sqrt(5));

// Growth_paint(Share)
// What every component has after its geometry: nothing. Declare a macro of this name after the include to paint. The
// parameters of the macro that calls it are visible in it, so that names of yours like Radius, Length or Width mean
// those.
// Share: of what grew, 0 for the first part (the body, the middle) to 1 for the last (the tips, the rim).
// Example: #macro Growth_paint(S) pigment { rgb S } #end union { Growth_urchin(0, 0.5, 99, 1, 0.03, seed(1)) }
#macro Growth_paint(Share) #end

// ---- Places ---------------------------------------------------------------------------------------------------------

// Growth_disc(I, Count)
// Place I of an even spiral of seeds on the disc of radius 1 across y (Vogel 1979): a sunflower.
// I: 0 (the middle) to Count - 1. Count: how many there are, 100 to 2000.
// Example: #for (I, 0, 299) sphere { Growth_disc(I, 300), 0.05 pigment { rgb <1, I/300, 0> } } #end
#macro Growth_disc(I, Count) (sqrt((I + 0.5)/Count)*vrotate(x, Growth_Angle*(I)*y)) #end

// Growth_cylinder(I, Count, Radius, Height)
// Place I of an even spiral round a cylinder about y, from the ground up: a pineapple, a stem.
// I: 0 to Count - 1. Count: how many. Radius, Height: of the cylinder.
// Example: #for (I, 0, 199) sphere { Growth_cylinder(I, 200, 0.5, 1.2), 0.07 pigment { rgb <1, I/200, 0> } } #end
#macro Growth_cylinder(I, Count, Radius, Height)
  (Radius*vrotate(x, Growth_Angle*(I)*y) + Height*(I + 0.5)/Count*y)
#end

// Growth_ball(I, Count)
// Place I of an even spiral on the sphere of radius 1, from the north pole to the south; a direction of length 1.
// I: 0 to Count - 1. Count: how many.
// Example: #for (I, 0, 299) sphere { Growth_ball(I, 300), 0.08 pigment { rgb <1, I/300, 0> } } #end
#macro Growth_ball(I, Count)
  #local Growth_H = 1 - (2*(I) + 1)/Count;
  (vrotate(<sqrt(1 - Growth_H*Growth_H), Growth_H, 0>, Growth_Angle*(I)*y))
#end

// Growth_dome(I, Count, Spread)
// Place I of an even spiral on a cap of that sphere about y.
// I: 0 (the pole) to Count - 1. Count: how many. Spread: the cap's half angle in degrees; 90 is half the sphere.
// Example: #for (I, 0, 199) sphere { Growth_dome(I, 200, 80), 0.08 pigment { rgb <1, I/200, 0> } } #end
#macro Growth_dome(I, Count, Spread)
  #local Growth_H = 1 - (I + 0.5)/Count*(1 - cos(radians(Spread)));
  (vrotate(<sqrt(max(1 - Growth_H*Growth_H, 0)), Growth_H, 0>, Growth_Angle*(I)*y))
#end

// Growth_spiral(Turns, Factor, Rise)
// A place of the logarithmic spiral that begins at x and winds about y, as shells do.
// Turns: how far it has gone round; any number, negative ones lead inwards. Factor: how much larger it is after each
// turn, 1.5 to 3.
// Rise: the height lost for each length outwards: 0 is flat, 1 to 3 a tower with its tip above.
// Example: #for (I, -90, 0) sphere { Growth_spiral(I/30, 2, 0), 0.3*pow(2, I/30) pigment { rgb <1, 0.8, 0.6> } } #end
#macro Growth_spiral(Turns, Factor, Rise)
  (pow(Factor, Turns)*vrotate(<1, -Rise, 0>, 360*(Turns)*y))
#end

// ---- Whole things ---------------------------------------------------------------------------------------------------

// Growth_urchin(Centre, Radius, Spines, Length, Width, Stream)
// A sea urchin: a ball and tapered spines all over it, a third of them long, the others short.
// Centre, Radius: of the ball. Spines: how many, 200 to 1000. Length: of the longest from the ball. Width: radius at
// their feet, usually a twentieth of the ball's. Stream: a stream of `seed`.
// Example: blob { kernel "gaussian" hardness 6 Growth_urchin(0, 0.5, 300, 0.6, 0.03, seed(1)) pigment { rgb 1 } }
#macro Growth_urchin(Centre, Radius, Spines, Length, Width, Stream)
  sphere { Centre, Radius Growth_paint(0) }
  #for (Growth_I, 0, Spines - 1)
    #local Growth_Push = <rand(Stream), rand(Stream), rand(Stream)> - 0.5;
    #local Growth_D = Growth_ball(Growth_I, Spines) + 0.12*Growth_Push;
    #local Growth_L = Length*(mod(Growth_I, 3) = 0 ? 0.75 + 0.25*rand(Stream) : 0.3 + 0.25*rand(Stream));
    cone {
      Centre + 0.9*Radius*Growth_D, Width, Centre + (Radius + Growth_L)*vnormalize(Growth_D), Width*0.2
      Growth_paint(1)
    }
  #end
#end

// Growth_cactus(Foot, Height, Radius, Ribs, Spines)
// A cactus that stands upright: a round body with ribs, and a star of spines at regular places on every rib.
// Foot: the middle of its ground. Height, Radius: of the body. Ribs: 8 to 20. Spines: groups on each rib, 6 to 20, or
// 0.
// Example: blob { kernel "quartic" hardness 5 Growth_cactus(-0.7*y, 1.4, 0.5, 12, 9) pigment { rgb <0.3, 0.5, 0.3> } }
#macro Growth_cactus(Foot, Height, Radius, Ribs, Spines)
  // The body is a short limb of balls, inside the ribs; a rib is a row of balls from the ground to the crown.
  #local Growth_Rib = 1.9*Radius/Ribs;
  cone { Foot + 0.75*Radius*y, 0.75*Radius, Foot + (Height - 0.8*Radius)*y, 0.68*Radius Growth_paint(0) }
  #for (Growth_I, 0, Ribs - 1)
    #local Growth_X = vrotate(x, 360*Growth_I/Ribs*y);
    #local Growth_Before = <0, 0, 0>;
    #for (Growth_J, 0, 14)
      // Up the side, narrower at the foot, and over the crown in a quarter of a circle.
      #local Growth_T = Growth_J/14;
      #local Growth_W = Radius*pow(max(0, 1 - pow(abs(2*Growth_T - 0.9)/1.1, 3)), 0.5);
      #local Growth_P = Foot + (Growth_W*0.9 + 0.02*Radius)*Growth_X + Growth_T*(Height - Growth_Rib)*y;
      #if (Growth_J > 0)
        cylinder { Growth_Before, Growth_P, Growth_Rib*0.55 strength 0.6 Growth_paint(0.3) }
      #end
      #local Growth_Before = Growth_P;
    #end
    #for (Growth_J, 1, Spines)
      #local Growth_T = 0.06 + 0.9*Growth_J/(Spines + 1);
      #local Growth_W = Radius*pow(max(0, 1 - pow(abs(2*Growth_T - 0.9)/1.1, 3)), 0.5);
      #local Growth_Up = Growth_T*(Height - Growth_Rib)*y;
      #local Growth_P = Foot + (Growth_W*0.9 + 0.02*Radius + 0.3*Growth_Rib)*Growth_X + Growth_Up;
      #local Growth_Out = vnormalize(Growth_X + max(0, 2*Growth_T - 0.9)*y);
      #local Growth_Lean = vnormalize(Growth_Out + 0.8*VPerp_To_Vector(Growth_Out));
      #for (Growth_K, 0, 4)
        #local Growth_D = vaxis_rotate(Growth_Lean, Growth_Out, 72*Growth_K + 30*Growth_J);
        cone { Growth_P, 0.022*Radius, Growth_P + 0.24*Radius*Growth_D, 0.008*Radius Growth_paint(1) }
      #end
    #end
  #end
#end

// Growth_shell(Centre, Radius, Turns, Factor, Rise, Ridges)
// A snail's or nautilus' shell: a tube along a logarithmic spiral about y, of balls that grow with it, in ridges.
// Centre: of the spiral. Radius: of the last turn. Turns: how many, 3 to 6. Factor: how much larger each turn is than
// the one before, 1.6 (tight) to 3 (nautilus). Rise: 0 for a flat one, 1 to 3 for a tower. Ridges: in each turn, 0 for
// a smooth tube.
// Example: blob { kernel "gaussian" hardness 5 Growth_shell(0.8*y, 0.8, 5, 1.7, 1.6, 12) pigment { rgb 1 } }
#macro Growth_shell(Centre, Radius, Turns, Factor, Rise, Ridges)
  // Tubes of neighbouring turns touch where their radius is this share of the distance from the axis.
  #local Growth_Share = (1 - 1/Factor)*sqrt(1 + Rise*Rise)/(1 + 1/Factor);
  #local Growth_Share = min(Growth_Share*1.05, 0.95);
  #local Growth_Count = 72;
  #for (Growth_I, -Turns*Growth_Count, 0)
    #local Growth_T = Growth_I/Growth_Count;
    #local Growth_R = Radius*pow(Factor, Growth_T)*Growth_Share;
    // So many balls overlap that each has a share of the strength; those on a ridge have more.
    #local Growth_S = min(1, 4*pi/(Growth_Count*Growth_Share));
    #if (Ridges > 0)
      #local Growth_Crest = (abs(Ridges*Growth_T - floor(Ridges*Growth_T + 0.5)) < 0.49*Ridges/Growth_Count);
      #local Growth_R = Growth_R*(Growth_Crest ? 1.04 : 0.88);
      #local Growth_S = (Growth_Crest ? 1 : Growth_S);
    #end
    #local Growth_P = Centre + Radius*Growth_spiral(Growth_T, Factor, Rise);
    sphere { Growth_P, Growth_R strength Growth_S Growth_paint(1 + Growth_T/Turns) }
  #end
#end

// Growth_sponge(Centre, Radius, Holes, Size, Stream)
// A sponge: a ball of lumps, with holes that balls of negative strength eat into it. For blobs alone.
// Centre, Radius: of the whole. Holes: how many, 40 to 400. Size: of the largest hole as a share of Radius, usually
// 0.2. Stream: a stream of `seed`.
// Example: blob { kernel "gaussian" hardness 4 Growth_sponge(0, 1, 120, 0.2, seed(3)) pigment { rgb 1 } }
#macro Growth_sponge(Centre, Radius, Holes, Size, Stream)
  sphere { Centre, 0.8*Radius Growth_paint(0) }
  #for (Growth_I, 0, 39)
    #local Growth_R = Radius*(0.15 + 0.1*rand(Stream));
    sphere { Centre + 0.7*Radius*Growth_ball(Growth_I, 40), Growth_R strength 0.7 Growth_paint(0.5) }
  #end
  #for (Growth_I, 0, Holes - 1)
    #local Growth_Push = <rand(Stream), rand(Stream), rand(Stream)> - 0.5;
    #local Growth_D = vnormalize(Growth_ball(Growth_I, Holes) + 1.2/sqrt(Holes)*Growth_Push);
    #local Growth_R = Radius*Size*(0.35 + 0.65*rand(Stream));
    #for (Growth_J, 0, 2)
      sphere { Centre + (0.95*Radius - 0.8*Growth_J*Growth_R)*Growth_D, Growth_R strength -2.5 Growth_paint(1) }
    #end
  #end
#end

// Growth_ruffle(Centre, Radius, Rings, Waves, Height, Width)
// A leaf or a lettuce coral whose rim has grown faster than its middle: rings about y whose waves double in number
// outwards and rise, as a surface with too much rim must. A blob of short limbs.
// Centre: the middle. Radius: of the rim. Rings: how many, 8 to 16; fewer leave gaps. Waves: of the first rings, 3 to
// 6. Height: of the rim's waves, usually a third of Radius. Width: the leaf's thickness, about Radius over Rings.
// Example: blob { kernel "gaussian" hardness 3 Growth_ruffle(0, 1, 12, 4, 0.3, 0.07) pigment { rgb <0.5, 0.8, 0.4> } }
#macro Growth_ruffle(Centre, Radius, Rings, Waves, Height, Width)
  #for (Growth_I, 1, Rings)
    #local Growth_T = Growth_I/Rings;
    #local Growth_R = Radius*Growth_T;
    #local Growth_Count = ceil(2*pi*Growth_R*(1 + 2*Growth_T)/Width);
    #local Growth_Before = <0, 0, 0>;
    #for (Growth_J, 0, Growth_Count)
      #local Growth_A = 360*Growth_J/Growth_Count;
      // Small waves ride on large ones from two thirds of the way on.
      #local Growth_Y = Height*(pow(Growth_T, 1.5)*sin(radians(Growth_A*Waves))
                                + 0.45*pow(max(0, Growth_T - 0.5)*2, 1.5)*sin(radians(Growth_A*Waves*2 + 60)));
      #local Growth_P = Centre + vrotate(<Growth_R, Growth_Y + 0.3*Height*Growth_T, 0>, Growth_A*y);
      #if (Growth_J > 0)
        sphere { (Growth_Before + Growth_P)/2, Width strength 0.55 Growth_paint(Growth_T) }
      #end
      #local Growth_Before = Growth_P;
    #end
  #end
#end

// Growth_polyp(Foot, Axis, Height, Radius, Arms)
// A polyp or an anemone: a stalk, a rim, and a crown of arms that bend outwards.
// Foot: where it grows. Axis: its direction. Height: of the stalk. Radius: of the stalk. Arms: 8 to 24.
// Example: blob { kernel "gaussian" hardness 4 Growth_polyp(-0.8*y, y, 0.8, 0.25, 16) pigment { rgb <1, 0.6, 0.7> } }
#macro Growth_polyp(Foot, Axis, Height, Radius, Arms)
  #local Growth_Y = vnormalize(Axis);
  #local Growth_Top = Foot + Height*Growth_Y;
  cone { Foot, Radius*1.1, Growth_Top, Radius Growth_paint(0) }
  #for (Growth_I, 0, Arms - 1)
    #local Growth_X = vaxis_rotate(VPerp_To_Vector(Growth_Y), Growth_Y, 360*Growth_I/Arms);
    #local Growth_P = Growth_Top + 0.75*Radius*Growth_X + 0.5*Radius*Growth_Y;
    #local Growth_Q = Growth_P + Radius*((1 + 0.3*mod(Growth_I, 2))*Growth_X + (1.2 - 0.5*mod(Growth_I, 2))*Growth_Y);
    cone { Growth_P, 0.16*Radius, Growth_Q, 0.12*Radius Growth_paint(0.5) }
    cone { Growth_Q, 0.12*Radius, Growth_Q + Radius*(0.7*Growth_X + 0.1*Growth_Y), 0.06*Radius Growth_paint(1) }
  #end
  sphere { Growth_Top + 0.9*Radius*Growth_Y, 0.55*Radius strength -1.2 Growth_paint(0) }
#end

#version Growth_Isl_Before;
#end
