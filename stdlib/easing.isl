// Curves of a number: how something goes from one value to another, and waves. For radii along a limb, sizes along a
// row, colours by height, and animations.
//
//   #include "easing.isl"
//
// T is the share of the way, from 0 to 1, and so is what the Ease macros give (but for the overshoot of Ease_back and
// Ease_elastic); T outside of that is cut off. All of them are numbers and stand wherever numbers do.
#ifndef (Easing_Isl_Before)
#declare Easing_Isl_Before = version;
#version 3.7;

// ---- Ranges ---------------------------------------------------------------------------------------------------------

// Ease_share(V, From, To)
// How far V is on the way from From to To, cut to 0 … 1. The inverse of Ease_mix.
// V, From, To: numbers; From may be the greater.
// Example: #for (I, -8, 8) sphere { I/8*x, 0.02 + 0.1*Ease_share(I, -4, 4) pigment { rgb 1 } } #end
#macro Ease_share(V, From, To) (max(0, min(1, (V - From)/(To - From)))) #end

// Ease_mix(A, B, T)
// The value at the share T of the straight way from A to B; T is not cut off.
// A, B: numbers, vectors or colours. T: usually 0 to 1.
// Example: #for (I, 0, 8) sphere { Ease_mix(-x, x + y/2, I/8), 0.1 pigment { rgb Ease_mix(x, x + y, I/8) } } #end
#macro Ease_mix(A, B, T) (A + (B - A)*(T)) #end

// Ease_remap(V, FromLow, FromHigh, ToLow, ToHigh)
// V, taken from one range to another in proportion and cut off at the other's ends.
// All: numbers; the ranges may fall.
// Example: #for (I, -8, 8) sphere { I/8*x, Ease_remap(abs(I), 0, 8, 0.15, 0.03) pigment { rgb 1 } } #end
#macro Ease_remap(V, FromLow, FromHigh, ToLow, ToHigh)
  (ToLow + (ToHigh - ToLow)*Ease_share(V, FromLow, FromHigh))
#end

// ---- Steps ----------------------------------------------------------------------------------------------------------

// Ease_step(V, From, To)
// 0 below From, 1 above To, and between them a smooth rise that begins and ends level: 3t² - 2t³.
// V, From, To: numbers.
// Example: #for (I, -20, 20) sphere { <I/20, 0.8*Ease_step(I, -10, 10), 0>, 0.05 pigment { rgb 1 } } #end
#macro Ease_step(V, From, To)
  #local Ease_S = Ease_share(V, From, To);
  (Ease_S*Ease_S*(3 - 2*Ease_S))
#end

// Ease_smoother_step(V, From, To)
// The same with curvature that begins and ends at zero too, for surfaces in which the other's ends show: 6t⁵ - 15t⁴ +
// 10t³.
// V, From, To: numbers.
// Example: #for (I, -20, 20) sphere { <I/20, 0.8*Ease_smoother_step(I, -10, 10), 0>, 0.05 pigment { rgb 1 } } #end
#macro Ease_smoother_step(V, From, To)
  #local Ease_S = Ease_share(V, From, To);
  (Ease_S*Ease_S*Ease_S*(Ease_S*(6*Ease_S - 15) + 10))
#end

// ---- From 0 to 1 ----------------------------------------------------------------------------------------------------

// Ease_in(T, Power)
// Begins slowly and ends fast.
// T: 0 to 1. Power: 1 is even, usually 2 or 3.
// Example: #for (I, 0, 20) sphere { <I/10 - 1, Ease_in(I/20, 2), 0>, 0.05 pigment { rgb 1 } } #end
#macro Ease_in(T, Power) (pow(Ease_share(T, 0, 1), Power)) #end

// Ease_out(T, Power)
// Begins fast and ends slowly.
// T: 0 to 1. Power: 1 is even, usually 2 or 3.
// Example: #for (I, 0, 20) sphere { <I/10 - 1, Ease_out(I/20, 2), 0>, 0.05 pigment { rgb 1 } } #end
#macro Ease_out(T, Power) (1 - pow(1 - Ease_share(T, 0, 1), Power)) #end

// Ease_in_out(T, Power)
// Begins and ends slowly.
// T: 0 to 1. Power: 1 is even, usually 2 or 3.
// Example: #for (I, 0, 20) sphere { <I/10 - 1, Ease_in_out(I/20, 3), 0>, 0.05 pigment { rgb 1 } } #end
#macro Ease_in_out(T, Power)
  #local Ease_S = Ease_share(T, 0, 1);
  (Ease_S < 0.5 ? pow(2*Ease_S, Power)/2 : 1 - pow(2 - 2*Ease_S, Power)/2)
#end

// Ease_back(T, Over)
// Rises beyond 1 and comes back to it.
// T: 0 to 1. Over: how far it overshoots, as a share of the way; usually 0.1.
// Example: #for (I, 0, 20) sphere { <I/10 - 1, Ease_back(I/20, 0.1), 0>, 0.05 pigment { rgb 1 } } #end
#macro Ease_back(T, Over)
  // The cubic 1 + (k + 1) s³ + k s² of s = T - 1 has its peak 4k³/(27 (k + 1)²) above 1. Each turn brings k nearer.
  #local Ease_S = Ease_share(T, 0, 1) - 1;
  #local Ease_K = 0;
  #for (I, 1, 30)
    #local Ease_K = pow(6.75*Over*(Ease_K + 1)*(Ease_K + 1), 1/3);
  #end
  (1 + (Ease_K + 1)*Ease_S*Ease_S*Ease_S + Ease_K*Ease_S*Ease_S)
#end

// Ease_elastic(T, Swings)
// Swings about 1, less and less, as a released spring does.
// T: 0 to 1. Swings: how often, usually 3.
// Example: #for (I, 0, 40) sphere { <I/20 - 1, 0.7*Ease_elastic(I/40, 3), 0>, 0.05 pigment { rgb 1 } } #end
#macro Ease_elastic(T, Swings)
  #local Ease_S = Ease_share(T, 0, 1);
  (1 - (1 - Ease_S)*exp(-5*Ease_S)*cos(2*pi*Swings*Ease_S))
#end

// Ease_bounce(T, Bounces, Keep)
// Falls to 1 as a ball falls to the ground, and bounces there, each time lower and shorter.
// T: 0 to 1. Bounces: how often it leaves the ground again, usually 3. Keep: the share of its height that each has of
// the one before, usually 0.3.
// Example: #for (I, 0, 60) sphere { <I/30 - 1, 1 - Ease_bounce(I/60, 3, 0.4), 0>, 0.03 pigment { rgb 1 } } #end
#macro Ease_bounce(T, Bounces, Keep)
  // A flight takes time in proportion to the root of its height; the first is half a flight.
  #local Ease_Root = sqrt(Keep);
  #local Ease_Time = 0.5;
  #for (I, 1, Bounces)
    #local Ease_Time = Ease_Time + pow(Ease_Root, I);
  #end
  #local Ease_Left = Ease_share(T, 0, 1)*Ease_Time + 0.5;
  #local Ease_Flight = 1;
  #local Ease_Turn = 0;
  #while (Ease_Left > Ease_Flight & Ease_Turn < Bounces)
    #local Ease_Left = Ease_Left - Ease_Flight;
    #local Ease_Flight = Ease_Flight*Ease_Root;
    #local Ease_Turn = Ease_Turn + 1;
  #end
  #local Ease_S = min(1, Ease_Left/Ease_Flight);
  (1 - 4*Ease_Flight*Ease_Flight*Ease_S*(1 - Ease_S))
#end

// Ease_bias(T, Middle)
// Bends the way so that it is at Middle when T is 1/2 (Perlin and Hoffert 1989).
// T: 0 to 1. Middle: above 0 and below 1; 0.5 changes nothing.
// Example: #for (I, 0, 20) sphere { <I/10 - 1, Ease_bias(I/20, 0.8), 0>, 0.05 pigment { rgb 1 } } #end
#macro Ease_bias(T, Middle) (pow(Ease_share(T, 0, 1), ln(Middle)/ln(0.5))) #end

// Ease_gain(T, Contrast)
// Flattens the ends of the way or its middle (Perlin and Hoffert 1989).
// T: 0 to 1. Contrast: above 0.5 and below 1 flattens the ends, below 0.5 and above 0 the middle; 0.5 changes nothing.
// Example: #for (I, 0, 20) sphere { <I/10 - 1, Ease_gain(I/20, 0.85), 0>, 0.05 pigment { rgb 1 } } #end
#macro Ease_gain(T, Contrast)
  #local Ease_S = Ease_share(T, 0, 1);
  #local Ease_Half = Ease_bias(1 - abs(2*Ease_S - 1), 1 - Contrast)/2;
  (Ease_S < 0.5 ? Ease_Half : 1 - Ease_Half)
#end

// Ease_arch(T, Sharpness)
// 0 at both ends and 1 in the middle: the thickness of a leaf, a fish, a worm.
// T: 0 to 1. Sharpness: 0.5 makes a half circle, 1 a parabola, 2 and more a peak with level ends.
// Example: #for (I, 0, 20) sphere { (I/10 - 1)*x, 0.02 + 0.3*Ease_arch(I/20, 0.7) pigment { rgb 1 } } #end
#macro Ease_arch(T, Sharpness)
  #local Ease_S = Ease_share(T, 0, 1);
  (pow(4*Ease_S*(1 - Ease_S), Sharpness))
#end

// ---- Waves ----------------------------------------------------------------------------------------------------------

// Wave_sine(V)
// A smooth wave from 0 up to 1 and back over every 1 of V, beginning with 0.
// V: any number.
// Example: #for (I, 0, 60) sphere { <I/30 - 1, 0.5*Wave_sine(I/20), 0>, 0.03 pigment { rgb 1 } } #end
#macro Wave_sine(V) ((1 - cos(2*pi*(V)))/2) #end

// Wave_triangle(V)
// Straight up from 0 to 1 and down again over every 1 of V.
// V: any number.
// Example: #for (I, 0, 60) sphere { <I/30 - 1, 0.5*Wave_triangle(I/20), 0>, 0.03 pigment { rgb 1 } } #end
#macro Wave_triangle(V) (1 - abs(2*((V) - floor(V)) - 1)) #end

// Wave_scallop(V)
// Arches from 0 to 1 that meet in sharp valleys, one in every 1 of V: the rim of a shell.
// V: any number.
// Example: #for (I, 0, 80) sphere { <I/40 - 1, 0.5*Wave_scallop(I/20), 0>, 0.03 pigment { rgb 1 } } #end
#macro Wave_scallop(V) (abs(sin(pi*(V)))) #end

// Wave_pulse(V, Share, Soft)
// 1 for a share of every 1 of V, else 0, with soft flanks: bands, rings, segments of a worm.
// V: any number. Share: of the time it is up, 0 to 1. Soft: width of each flank as a share of 1, usually 0.1.
// Example: #for (I, 0, 90) sphere { <I/45 - 1, 0.4*Wave_pulse(I/30, 0.5, 0.2), 0>, 0.03 pigment { rgb 1 } } #end
#macro Wave_pulse(V, Share, Soft)
  #local Ease_Off = abs((V) - floor(V) - 0.5);
  (1 - Ease_step(Ease_Off, Share/2 - Soft/2, Share/2 + Soft/2))
#end

#version Easing_Isl_Before;
#end
