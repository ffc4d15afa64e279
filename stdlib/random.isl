// Random numbers for growing things: streams by name, numbers, directions and places, choices.
//
//   #include "random.isl"
//
// Every macro that draws takes a stream, which `seed(N)` or Random_stream makes, and draws a fixed number of times, so
// that a scene keeps its shape when one part of it changes. The file includes rand.inc, whose distributions serve as
// well.
#ifndef (Random_Isl_Before)
#declare Random_Isl_Before = version;
#version 3.7;
#include "rand.inc"
#include "math.inc"

// ---- Streams --------------------------------------------------------------------------------------------------------

// Random_stream(Name, Seed)
// A stream that belongs to a name: streams of different names have nothing in common, so that a new one in a scene
// leaves all others as they were.
// Name: any string. Seed: a whole number, usually 1; others give the same scene another fall of the dice.
// Example: #declare Bark = Random_stream("bark", 1); sphere { 0, rand(Bark) pigment { rgb 1 } }
#macro Random_stream(Name, Seed)
  #local Hash = mod(abs(Seed)*7919 + 17, 1000003);
  #for (I, 1, strlen(Name))
    #local Hash = mod(Hash*131 + asc(substr(Name, I, 1)), 1000003);
  #end
  (seed(Hash + 1))
#end

// ---- Numbers --------------------------------------------------------------------------------------------------------

// Random_between(Low, High, Stream)
// Something on the straight way from Low to High: a number, a point of a line, a colour between two. One draw.
// Low, High: numbers or vectors. Stream: a stream.
// Example: #declare S = seed(2); #for (I, -4, 4) sphere { I*x/4, Random_between(0.05, 0.15, S) pigment { rgb 1 } } #end
#macro Random_between(Low, High, Stream) (Low + (High - Low)*rand(Stream)) #end

// Random_vary(Value, Share, Stream)
// Value, larger or smaller by up to a share of itself. One draw.
// Value: a number or a vector. Share: 0 (no change) to 1 (from nothing to twice as much), usually 0.1 to 0.4.
// Example: #declare S = seed(2); #for (I, -4, 4) cylinder { I*x/4, I*x/4 + Random_vary(y, 0.4, S)/2, 0.1 } #end
#macro Random_vary(Value, Share, Stream) (Value*(1 + Share*(2*rand(Stream) - 1))) #end

// Random_integer(Low, High, Stream)
// A whole number from Low to High, both included, all equally likely. One draw.
// Low, High: whole numbers.
// Example: #declare S = seed(1); #for (I, 1, Random_integer(3, 9, S)) sphere { I/4*x - x, 0.1 pigment { rgb 1 } } #end
#macro Random_integer(Low, High, Stream) (min(High, Low + floor((High - Low + 1)*rand(Stream)))) #end

// Random_normal(Mean, Deviation, Stream)
// A normally distributed number (Box and Muller 1958), cut off at four deviations so that no part of a scene runs
// away. Always two draws; Rand_Gauss of rand.inc draws once a call, but remembers.
// Mean, Deviation: numbers; usually a Deviation of a fifth of the Mean for the sizes of living things.
// Example: #declare S = seed(3); #for (I, 1, 90) sphere { <Random_normal(0, 0.5, S), I/99 - 0.5, 0>, 0.05 } #end
#macro Random_normal(Mean, Deviation, Stream)
  #local Length = min(sqrt(-2*ln(1 - rand(Stream))), 4);
  (Mean + Deviation*Length*cos(2*pi*rand(Stream)))
#end

// ---- Directions and places ------------------------------------------------------------------------------------------

// Random_on_sphere(Centre, Radius, Stream)
// A point of a sphere's surface, all parts equally likely. Two draws.
// Centre: a point. Radius: a length; with Centre 0 and Radius 1 the point is a direction.
// Example: #declare S = seed(4); #for (I, 1, 200) sphere { Random_on_sphere(0, 1, S), 0.07 pigment { rgb 1 } } #end
#macro Random_on_sphere(Centre, Radius, Stream)
  #local Height = 2*rand(Stream) - 1;
  #local Turn = 2*pi*rand(Stream);
  #local Width = sqrt(1 - Height*Height);
  (Centre + Radius*<Width*cos(Turn), Height, Width*sin(Turn)>)
#end

// Random_in_ball(Centre, Radius, Stream)
// A point within a ball, all parts equally likely. Three draws.
// Centre: a point. Radius: a length.
// Example: #declare S = seed(5); #for (I, 1, 300) sphere { Random_in_ball(0, 1, S), 0.05 pigment { rgb 1 } } #end
#macro Random_in_ball(Centre, Radius, Stream)
  #local Share = pow(rand(Stream), 1/3);
  Random_on_sphere(Centre, Radius*Share, Stream)
#end

// Random_on_disc(Centre, Normal, Radius, Stream)
// A point of a flat disc, all parts equally likely. Two draws.
// Centre: a point. Normal: the direction across the disc. Radius: a length.
// Example: #declare S = seed(6); #for (I, 1, 200) sphere { Random_on_disc(0, <1, 2, -1>, 1, S), 0.05 } #end
#macro Random_on_disc(Centre, Normal, Radius, Stream)
  #local Away = Radius*sqrt(rand(Stream));
  #local Turn = 360*rand(Stream);
  (Centre + Away*vaxis_rotate(VPerp_To_Vector(Normal), Normal, Turn))
#end

// Random_towards(Axis, Spread, Stream)
// A direction of length 1 within a cone, all parts of the cap equally likely. Two draws.
// Axis: the cone's direction. Spread: the half angle at its tip in degrees, 0 to 180, usually 10 to 40.
// Example: #declare S = seed(7); #for (I, 1, 90) cylinder { 0, Random_towards(y, 30, S), 0.02 } #end
#macro Random_towards(Axis, Spread, Stream)
  #local Forward = vnormalize(Axis);
  #local Height = 1 - rand(Stream)*(1 - cos(radians(Spread)));
  #local Turn = 360*rand(Stream);
  (Height*Forward + sqrt(max(1 - Height*Height, 0))*vaxis_rotate(VPerp_To_Vector(Forward), Forward, Turn))
#end

// ---- Choices --------------------------------------------------------------------------------------------------------

// Random_choice(Items, Stream)
// One of the elements of an array. One draw.
// Items: an array of one dimension, of values of any kind that can stand where the macro is called.
// Example: #declare S = seed(8); #for (I, -4, 4) sphere { I*x/4, Random_choice(array[3] {0.05, 0.1, 0.2}, S) } #end
#macro Random_choice(Items, Stream)
  Items[min(dimension_size(Items, 1) - 1, floor(dimension_size(Items, 1)*rand(Stream)))]
#end

// Random_weighted(Weights, Stream)
// The index of one of the weights, each as likely as it is large. One draw.
// Weights: an array of numbers of 0 or more.
// Example: #declare S = seed(9); #for (I, -4, 4) sphere { I*x/4, 0.05 + 0.1*Random_weighted(array[2] {3, 1}, S) } #end
#macro Random_weighted(Weights, Stream)
  #local Sum = 0;
  #for (I, 0, dimension_size(Weights, 1) - 1)
    #local Sum = Sum + Weights[I];
  #end
  #local Left = Sum*rand(Stream);
  #local Found = 0;
  #while (Found < dimension_size(Weights, 1) - 1 & Left >= Weights[min(Found, dimension_size(Weights, 1) - 1)])
    #local Left = Left - Weights[Found];
    #local Found = Found + 1;
  #end
  (Found)
#end

// Random_shuffle(Items, Stream)
// Puts the elements of an array in another order, all orders equally likely (Fisher and Yates). The array itself is
// changed.
// Items: the name of an array of one dimension. Draws once an element.
// Example: #declare H = array[4] {0,1,2,3} Random_shuffle(H, seed(3)) #for (I, 0, 3) sphere { <I, H[I]>/3, 0.1 } #end
#macro Random_shuffle(Items, Stream)
  #for (I, dimension_size(Items, 1) - 1, 1, -1)
    #local Other = min(I, floor((I + 1)*rand(Stream)));
    #local Kept = Items[I];
    #declare Items[I] = Items[Other];
    #declare Items[Other] = Kept;
  #end
#end

#version Random_Isl_Before;
#end
