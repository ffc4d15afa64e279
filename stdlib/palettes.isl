// Perceptual ramps: colours of a number from 0 to 1 in which equal steps of the number look like equal steps of colour.
//
//   #include "palettes.isl"
//   pigment { RampColour(AutumnRamp, 0.3) }                one colour, for loops and macros
//   pigment { gradient y RampMap(AutumnRamp) }             a colour map, for patterns
//
// A ramp is a spline through OKLab, the perceptual colour space of B. Ottosson, "A perceptual color space for image
// processing" (2020, https://bottosson.github.io/posts/oklab/). With linear light R, G, B:
//   l, m, s = the cube roots of M1 <R, G, B>,   <L, a, b> = M2 <l, m, s>
// L is lightness, 0 for black and 1 for white; a goes from green to red, b from blue to yellow. Chroma is the length of
// <a, b>, hue its angle. The parameter of a ramp is the length of its way through this space, so that it has an even
// speed.
#ifndef (Palettes_Isl_Before)
#declare Palettes_Isl_Before = version;
#version 3.7;

// ---- Colour spaces --------------------------------------------------------------------------------------------------

// The cube root of a number of either sign.
#macro Palettes_Isl_Root(A)
  (A < 0 ? -pow(-min(A, 0), 1/3) : pow(max(A, 0), 1/3))
#end

// RgbToOklab(Colour)
// The OKLab coordinates <L, a, b> of a colour in linear light.
// Colour: a colour or a vector of red, green, blue.
// Example: sphere { 0, 1 pigment { rgb RgbToOklab(rgb <1, 0.5, 0.2>).x } }
#macro RgbToOklab(Colour)
  #local Rgb_ = <0, 0, 0, 0, 0> + Colour;
  #local L_ = Palettes_Isl_Root(0.4122214708*Rgb_.red + 0.5363325363*Rgb_.green + 0.0514459929*Rgb_.blue);
  #local M_ = Palettes_Isl_Root(0.2119034982*Rgb_.red + 0.6806995451*Rgb_.green + 0.1073969566*Rgb_.blue);
  #local S_ = Palettes_Isl_Root(0.0883024619*Rgb_.red + 0.2817188376*Rgb_.green + 0.6299787005*Rgb_.blue);
  <0.2104542553*L_ + 0.7936177850*M_ - 0.0040720468*S_,
   1.9779984951*L_ - 2.4285922050*M_ + 0.4505937099*S_,
   0.0259040371*L_ + 0.7827717662*M_ - 0.8086757660*S_>
#end

// The linear light of OKLab coordinates; terms are below 0 or above 1 where no screen shows the colour.
#macro Palettes_Isl_Light(Lab)
  #local L_ = pow(Lab.x + 0.3963377774*Lab.y + 0.2158037573*Lab.z, 3);
  #local M_ = pow(Lab.x - 0.1055613458*Lab.y - 0.0638541728*Lab.z, 3);
  #local S_ = pow(Lab.x - 0.0894841775*Lab.y - 1.2914855480*Lab.z, 3);
  <4.0767416621*L_ - 3.3077115913*M_ + 0.2309699292*S_,
   -1.2684380046*L_ + 2.6097574011*M_ - 0.3413193965*S_,
   -0.0041960863*L_ - 0.7034186147*M_ + 1.7076147010*S_>
#end

// 1 where all terms of a light are from 0 to 1, give or take a thousandth.
#macro Palettes_Isl_Shown(Light)
  (min(Light.x, Light.y, Light.z) > -0.001 & max(Light.x, Light.y, Light.z) < 1.001)
#end

// OklabToRgb(Lab)
// The colour, in linear light, of OKLab coordinates. What is too colourful for a screen gets less chroma, at the same
// lightness and hue.
// Lab: <L, a, b>, with L from 0 to 1 and a and b from about -0.3 to 0.3.
// Example: sphere { 0, 1 pigment { OklabToRgb(<0.7, 0.12, 0.08>) } }
#macro OklabToRgb(Lab)
  #local Lab_ = <max(0, min(1, Lab.x)), Lab.y, Lab.z>;
  #local Light_ = Palettes_Isl_Light(Lab_);
  #if (!Palettes_Isl_Shown(Light_))
    // Bisection: the largest share of the chroma that is shown. 12 steps leave 1/4096 of it.
    #local Least_ = 0;
    #local Most_ = 1;
    #for (Step_, 1, 12)
      #local Share_ = (Least_ + Most_)/2;
      #if (Palettes_Isl_Shown(Palettes_Isl_Light(Lab_*<1, Share_, Share_>)))
        #local Least_ = Share_;
      #else
        #local Most_ = Share_;
      #end
    #end
    #local Light_ = Palettes_Isl_Light(Lab_*<1, Least_, Least_>);
  #end
  #local Shown_ = rgb <max(0, min(1, Light_.x)), max(0, min(1, Light_.y)), max(0, min(1, Light_.z))>;
  Shown_
#end

// LchColour(Lightness, Chroma, Hue)
// A colour by what the eye sees of it: hues at the same Lightness and Chroma look equally bright and colourful.
// Lightness: 0 black … 1 white. Chroma: 0 grey, 0.1 soft, 0.2 strong. Hue: degrees; about 30 red, 60 orange, 105
// yellow, 145 green, 195 cyan, 260 blue, 310 violet.
// Example: #for (I, 0, 5) sphere { <0.6*(I - 2.5), 0, 0>, 0.3 pigment { LchColour(0.75, 0.12, 60*I) } } #end
#macro LchColour(Lightness, Chroma, Hue)
  OklabToRgb(<Lightness, Chroma*cos(radians(Hue)), Chroma*sin(radians(Hue))>)
#end

// MixColours(First, Second, Share)
// The colour between two others, mixed as the eye expects it: without the mud between red and green.
// Share: 0 gives First, 1 Second.
// Example: sphere { 0, 1 pigment { MixColours(rgb <1, 0.1, 0.1>, rgb <0.1, 0.2, 1>, 0.5) } }
#macro MixColours(First, Second, Share)
  #local From_ = RgbToOklab(First);
  #local To_ = RgbToOklab(Second);
  OklabToRgb(From_ + Share*(To_ - From_))
#end

// ShadeColour(Colour, Amount)
// A lighter or a darker colour of the same hue.
// Amount: what is added to the lightness; -0.2 is clearly darker, 0.2 clearly lighter.
// Example: sphere { 0, 1 pigment { ShadeColour(rgb <0.8, 0.3, 0.1>, -0.15) } }
#macro ShadeColour(Colour, Amount)
  #local From_ = RgbToOklab(Colour);
  OklabToRgb(<From_.x + Amount, From_.y, From_.z>)
#end

// TurnHue(Colour, Angle)
// The colour with another hue, at the same lightness.
// Angle: degrees; 30 is a neighbour, 180 the complement.
// Example: sphere { 0, 1 pigment { TurnHue(rgb <0.8, 0.3, 0.1>, 30) } }
#macro TurnHue(Colour, Angle)
  #local From_ = RgbToOklab(Colour);
  #local C_ = cos(radians(Angle));
  #local S_ = sin(radians(Angle));
  OklabToRgb(<From_.x, C_*From_.y - S_*From_.z, S_*From_.y + C_*From_.z>)
#end

// ---- Ramps ----------------------------------------------------------------------------------------------------------

// A spline through Lab[0] … Lab[Last], the ends of which are followed by what lies beyond them, so that it passes
// through both. Its parameter is 0 at Lab[0] and 1 at Lab[Last], and grows with the distance between the colours.
#macro Palettes_Isl_Spline(Lab, Last, Before, After)
  #local Way_ = array[Last + 1];
  #local Way_[0] = 0;
  #for (I_, 1, Last)
    #local Way_[I_] = Way_[I_ - 1] + max(1e-4, vlength(Lab[I_] - Lab[I_ - 1]));
  #end
  spline {
    cubic_spline
    -max(1e-4, vlength(Lab[0] - Before))/Way_[Last], Before
    #for (I_, 0, Last)
      Way_[I_]/Way_[Last], Lab[I_]
    #end
    1 + max(1e-4, vlength(After - Lab[Last]))/Way_[Last], After
  }
#end

// MakeRamp(Colours)
// A ramp through the colours of an array, smooth and at an even speed.
// Colours: an array of two or more colours; order them from dark to light for a ramp that tells more from less.
// Example: #declare Mine = MakeRamp(array[3] { rgb <0.1, 0, 0.2>, rgb <0.8, 0.1, 0.2>, rgb <1, 0.9, 0.6> })
//   sphere { 0, 1 pigment { gradient y RampMap(Mine) scale 2 translate -y } }
#macro MakeRamp(Colours)
  #local Last_ = dimension_size(Colours, 1) - 1;
  #local Lab_ = array[Last_ + 1];
  #for (K_, 0, Last_)
    #local Lab_[K_] = RgbToOklab(Colours[K_]);
  #end
  Palettes_Isl_Spline(Lab_, Last_, 2*Lab_[0] - Lab_[1], 2*Lab_[Last_] - Lab_[Last_ - 1])
#end

// MakeCyclicRamp(Colours)
// A ramp that returns to its first colour, for angles, hours and seasons.
// Colours: an array of three or more colours; the first is not repeated at the end.
// Example: #declare Mine = MakeCyclicRamp(array[3] { rgb <0.8, 0.2, 0.1>, rgb <0.9, 0.8, 0.3>, rgb <0.1, 0.3, 0.6> })
//   sphere { 0, 1 pigment { radial RampMap(Mine) } }
#macro MakeCyclicRamp(Colours)
  #local Count_ = dimension_size(Colours, 1);
  #local Lab_ = array[Count_ + 1];
  #for (K_, 0, Count_)
    #local Lab_[K_] = RgbToOklab(Colours[mod(K_, Count_)]);
  #end
  Palettes_Isl_Spline(Lab_, Count_, Lab_[Count_ - 1], Lab_[1])
#end

// MakeHueRamp(From, To)
// A ramp from one colour to another around the circle of hues instead of straight through grey.
// From, To: <lightness, chroma, hue> as in LchColour; a hue beyond 360 goes once around.
// Example: #declare Mine = MakeHueRamp(<0.3, 0.08, 300>, <0.92, 0.1, 100>)
//   sphere { 0, 1 pigment { gradient y RampMap(Mine) scale 2 translate -y } }
#macro MakeHueRamp(From, To)
  #local Lab_ = array[11];
  #for (K_, 0, 10)
    #local Lch_ = From + (To - From)*K_/10;
    #local Lab_[K_] = <Lch_.x, Lch_.y*cos(radians(Lch_.z)), Lch_.y*sin(radians(Lch_.z))>;
  #end
  Palettes_Isl_Spline(Lab_, 10, 2*Lab_[0] - Lab_[1], 2*Lab_[10] - Lab_[9])
#end

// RampColour(Ramp, Value)
// The colour of a number.
// Value: 0 is the ramp's beginning, 1 its end; what lies outside has the colour of the nearer end.
// Example: #for (I, 0, 8) sphere { <I/2 - 2, 0, 0>, 0.3 pigment { RampColour(ReefRamp, I/8) } } #end
#macro RampColour(Ramp, Value)
  OklabToRgb(<0, 0, 0> + Ramp(max(0, min(1, Value))))
#end

// CyclicColour(Ramp, Value)
// The colour of a number that goes round: 0, 1 and 2 are the same.
// Example: #for (I, 0, 11) sphere { 1.2*x, 0.28 pigment { CyclicColour(HueRamp, I/12) } rotate 30*I*z } #end
#macro CyclicColour(Ramp, Value)
  RampColour(Ramp, Value - floor(Value))
#end

// RampMap(Ramp)
// The ramp as a color_map, for a pattern.
// Example: sphere { 0, 1 pigment { bozo RampMap(GlacierRamp) scale 0.4 } }
#macro RampMap(Ramp)
  RampMapBetween(Ramp, 0, 1)
#end

// RampMapBetween(Ramp, Low, High)
// A part of the ramp as a color_map. A Low above High turns it round.
// Low, High: the numbers of the ramp at the pattern's 0 and 1.
// Example: sphere { 0, 1 pigment { onion RampMapBetween(DuskRamp, 1, 0.3) scale 0.5 } }
#macro RampMapBetween(Ramp, Low, High)
  color_map {
    // 16 pieces: between them colours are mixed in linear light, which is close enough to be invisible.
    #for (Piece_, 0, 16)
      [Piece_/16 RampColour(Ramp, Low + (High - Low)*Piece_/16)]
    #end
  }
#end

// RampSteps(Ramp, Count)
// The ramp as a color_map of so many flat steps, as on a map of heights.
// Count: 2 or more.
// Example: sphere { 0, 1 pigment { gradient y RampSteps(MeadowRamp, 6) scale 2 translate -y } }
#macro RampSteps(Ramp, Count)
  color_map {
    #for (Piece_, 0, Count - 1)
      [Piece_/Count RampColour(Ramp, Piece_/(Count - 1))]
      [(Piece_ + 1)/Count RampColour(Ramp, Piece_/(Count - 1))]
    #end
  }
#end

// LimbPigment(Ramp)
// A pigment that goes along each component of a blob with a kernel, from its first end to the second, wherever it
// leads.
// Example: blob { kernel "gaussian" cone { -x, 0.5, <1, 0.8, 0>, 0.15 } cone { -x, 0.4, <0.5, -0.9, 0>, 0.1 }
//   LimbPigment(ReefRamp) }
#macro LimbPigment(Ramp)
  pigment { uv_mapping gradient x RampMap(Ramp) scale 1.001 }
#end

// RampPartner(Ramp, Index)
// Colours for separate things: as different from one another as the ramp allows, however many there will be.
// Index: 0, 1, 2 …; numbers follow the golden section, so that neighbours are far apart.
// Example: #for (I, 0, 8) sphere { <I/2 - 2, 0, 0>, 0.3 pigment { RampPartner(ReefRamp, I) } } #end
#macro RampPartner(Ramp, Index)
  CyclicColour(Ramp, 0.5 + Index*0.6180339887)
#end

// ---- Sequential ramps: from dark to light, for what is more or less -------------------------------------------------

// GraphiteRamp: ramp. Warm greys from near black to paper white.
#declare GraphiteRamp = MakeRamp(array[3] { srgb <0.09, 0.09, 0.10>, srgb <0.50, 0.49, 0.47>, srgb <0.96, 0.95, 0.92> })
// EmberRamp: ramp. Charcoal, deep red, orange, pale yellow: heat and glow.
#declare EmberRamp = MakeRamp(array[5] {
  srgb <0.09, 0.06, 0.10>, srgb <0.46, 0.08, 0.14>, srgb <0.82, 0.26, 0.11>, srgb <0.98, 0.62, 0.22>,
    srgb <1.00, 0.95, 0.74> })
// GlacierRamp: ramp. Night blue through cold turquoise to snow.
#declare GlacierRamp = MakeRamp(array[5] {
  srgb <0.04, 0.11, 0.23>, srgb <0.08, 0.31, 0.47>, srgb <0.26, 0.57, 0.68>, srgb <0.62, 0.81, 0.86>,
    srgb <0.96, 0.98, 0.98> })
// FernRamp: ramp. Forest shadow through fern green to young shoots.
#declare FernRamp = MakeRamp(array[4] {
  srgb <0.05, 0.14, 0.11>, srgb <0.13, 0.38, 0.22>, srgb <0.50, 0.64, 0.25>, srgb <0.93, 0.94, 0.66> })
// OrchidRamp: ramp. Aubergine through magenta to petal white.
#declare OrchidRamp = MakeRamp(array[4] {
  srgb <0.15, 0.06, 0.20>, srgb <0.50, 0.16, 0.45>, srgb <0.85, 0.47, 0.66>, srgb <0.99, 0.91, 0.92> })
// HoneyRamp: ramp. Dark comb through amber to light wax.
#declare HoneyRamp = MakeRamp(array[4] {
  srgb <0.20, 0.10, 0.04>, srgb <0.58, 0.31, 0.06>, srgb <0.91, 0.63, 0.16>, srgb <1.00, 0.94, 0.73> })
// VioletFireRamp: ramp. Ink, violet, rose, apricot, cream: the widest range of lightness and hue, for data and depth.
#declare VioletFireRamp = MakeRamp(array[6] {
  srgb <0.05, 0.04, 0.14>, srgb <0.26, 0.12, 0.42>, srgb <0.58, 0.20, 0.49>, srgb <0.88, 0.37, 0.40>,
    srgb <0.98, 0.66, 0.40>,
  srgb <0.99, 0.95, 0.80> })

// ---- Diverging ramps: a neutral middle between two opposites --------------------------------------------------------

// CoralTealRamp: ramp. Coral red and deep teal on both sides of ivory.
#declare CoralTealRamp = MakeRamp(array[5] {
  srgb <0.62, 0.15, 0.15>, srgb <0.92, 0.50, 0.39>, srgb <0.96, 0.94, 0.88>, srgb <0.42, 0.69, 0.67>,
    srgb <0.05, 0.34, 0.37> })
// PlumMossRamp: ramp. Plum and moss green on both sides of a light grey.
#declare PlumMossRamp = MakeRamp(array[5] {
  srgb <0.37, 0.12, 0.36>, srgb <0.68, 0.47, 0.66>, srgb <0.94, 0.93, 0.91>, srgb <0.58, 0.69, 0.42>,
    srgb <0.20, 0.36, 0.13> })
// CopperSeaRamp: ramp. Copper and sea blue on both sides of a dark middle, so that both ends shine.
#declare CopperSeaRamp = MakeRamp(array[5] {
  srgb <0.99, 0.77, 0.56>, srgb <0.70, 0.36, 0.19>, srgb <0.13, 0.12, 0.14>, srgb <0.13, 0.40, 0.60>,
    srgb <0.60, 0.84, 0.95> })

// ---- Cyclic ramps: the end meets the beginning ----------------------------------------------------------------------

// HueRamp: ramp. Every hue at the same lightness and chroma: no hue stands out, as yellow and cyan do in a rainbow.
#declare HueRamp = MakeCyclicRamp(array[12] { #for (I, 0, 11) LchColour(0.74, 0.125, 30*I + 20) #end })
// SeasonsRamp: ramp. Snow, spring green, summer green, autumn red, bare brown, and snow again.
#declare SeasonsRamp = MakeCyclicRamp(array[6] {
  srgb <0.90, 0.93, 0.96>, srgb <0.74, 0.86, 0.50>, srgb <0.20, 0.50, 0.22>, srgb <0.87, 0.60, 0.16>,
    srgb <0.64, 0.20, 0.12>,
  srgb <0.45, 0.40, 0.40> })
// DayRamp: ramp. Midnight, dawn, noon, dusk, and midnight again.
#declare DayRamp = MakeCyclicRamp(array[8] {
  srgb <0.04, 0.06, 0.16>, srgb <0.24, 0.20, 0.42>, srgb <0.92, 0.60, 0.52>, srgb <0.98, 0.88, 0.66>,
    srgb <0.62, 0.83, 0.96>,
  srgb <0.97, 0.80, 0.47>, srgb <0.83, 0.38, 0.34>, srgb <0.26, 0.14, 0.36> })

// ---- Natural ramps --------------------------------------------------------------------------------------------------

// ReefRamp: ramp. A coral reef: deep water, violet fans, red coral, orange polyps, sunlit sand.
#declare ReefRamp = MakeRamp(array[6] {
  srgb <0.04, 0.20, 0.33>, srgb <0.33, 0.22, 0.47>, srgb <0.76, 0.19, 0.35>, srgb <0.95, 0.40, 0.29>,
    srgb <0.99, 0.68, 0.42>,
  srgb <0.99, 0.92, 0.77> })
// AutumnRamp: ramp. Autumn leaves: wet bark, crimson, rust, amber, the last yellow-green.
#declare AutumnRamp = MakeRamp(array[6] {
  srgb <0.17, 0.09, 0.08>, srgb <0.45, 0.10, 0.10>, srgb <0.72, 0.26, 0.09>, srgb <0.89, 0.50, 0.12>,
    srgb <0.95, 0.76, 0.28>,
  srgb <0.80, 0.82, 0.45> })
// DuskRamp: ramp. The sky after sunset from the zenith down: indigo, mauve, rose, apricot, pale gold.
#declare DuskRamp = MakeRamp(array[6] {
  srgb <0.07, 0.09, 0.24>, srgb <0.26, 0.21, 0.44>, srgb <0.58, 0.34, 0.53>, srgb <0.89, 0.49, 0.47>,
    srgb <0.98, 0.71, 0.48>,
  srgb <1.00, 0.91, 0.70> })
// DeepSeaRamp: ramp. From the floor of the sea to its sunlit surface.
#declare DeepSeaRamp = MakeRamp(array[5] {
  srgb <0.02, 0.04, 0.12>, srgb <0.03, 0.15, 0.32>, srgb <0.04, 0.38, 0.50>, srgb <0.26, 0.67, 0.66>,
    srgb <0.80, 0.95, 0.86> })
// MeadowRamp: ramp. Earth, grass, clover, buttercups.
#declare MeadowRamp = MakeRamp(array[5] {
  srgb <0.20, 0.14, 0.09>, srgb <0.22, 0.34, 0.13>, srgb <0.41, 0.57, 0.20>, srgb <0.72, 0.76, 0.33>,
    srgb <0.98, 0.91, 0.47> })
// DesertRamp: ramp. Canyon shadow, red rock, ochre dunes, bleached sand.
#declare DesertRamp = MakeRamp(array[5] {
  srgb <0.21, 0.11, 0.15>, srgb <0.50, 0.22, 0.17>, srgb <0.78, 0.44, 0.27>, srgb <0.91, 0.70, 0.46>,
    srgb <0.98, 0.92, 0.79> })
// LichenRamp: ramp. Rock, grey-green lichen, sulphur yellow, a touch of orange.
#declare LichenRamp = MakeRamp(array[5] {
  srgb <0.20, 0.21, 0.22>, srgb <0.42, 0.47, 0.43>, srgb <0.68, 0.73, 0.57>, srgb <0.87, 0.84, 0.42>,
    srgb <0.94, 0.63, 0.22> })
// NacreRamp: ramp. The pale greens, roses and blues of the inside of a shell, all of the same lightness; also cyclic.
#declare NacreRamp = MakeCyclicRamp(array[5] {
  srgb <0.92, 0.85, 0.86>, srgb <0.90, 0.87, 0.78>, srgb <0.79, 0.90, 0.83>, srgb <0.78, 0.88, 0.94>,
    srgb <0.87, 0.84, 0.94> })
// BruiseRamp: ramp. Skin, rose, wine, violet, blue-black: petals, bruises and octopus arms.
#declare BruiseRamp = MakeRamp(array[5] {
  srgb <0.98, 0.86, 0.76>, srgb <0.90, 0.58, 0.55>, srgb <0.60, 0.24, 0.36>, srgb <0.32, 0.15, 0.34>,
    srgb <0.09, 0.08, 0.18> })

#version Palettes_Isl_Before;
#end
