// Plastics, rubbers, lacquers and paints: the surfaces of things that are made.
//
//   #include "plastics.isl"
//   sphere { 0, 1 HardPlastic(rgb <0.7, 0.05, 0.03>) }
//   sphere { 0, 1 texture { MidnightLacquer } }
//
// Most take any colour. Made for things about 2 units large; scale the texture with them.
#ifndef (Plastics_Isl_Before)
#declare Plastics_Isl_Before = version;
#version 3.7;
#include "finishes.isl"

// ---- Macros ---------------------------------------------------------------------------------------------------------

// HardPlastic(Colour)
// Injection moulded: even colour, a clear white highlight. The plain material for any form.
// Colour: in linear light; keep each component below 0.8.
// Example: sphere { 0, 1 HardPlastic(rgb <0.7, 0.05, 0.03>) }
#macro HardPlastic(Colour)
  texture { pigment { color Colour } finish { GlossyFinish(0.82) } }
#end

// SoftPlastic(Colour)
// Matt, warm to the touch, with a fine grain: grips, cases, figures of vinyl.
// Example: sphere { 0, 1 SoftPlastic(rgb <0.9, 0.45, 0.1>) }
#macro SoftPlastic(Colour)
  texture {
    pigment { aoi color_map { [0.5 color 1.12*Colour] [0.75 color Colour] } }
    normal { bumps 0.08 scale 0.012 }
    finish { ambient 0.09 diffuse 0.82 brilliance 0.8 specular albedo 0.04 roughness 0.09 }
  }
#end

// RubberTexture(Colour)
// Dull, with a faint bloom towards the rims.
// Example: sphere { 0, 1 RubberTexture(rgb 0.03) }
#macro RubberTexture(Colour)
  texture {
    pigment { aoi color_map { [0.5 color Colour + <0.05, 0.05, 0.055, 0, 0>] [0.7 color Colour] } }
    normal { bumps 0.05 scale 0.03 }
    finish { ambient 0.08 diffuse 0.8 specular albedo 0.03 roughness 0.2 }
  }
#end

// LacquerTexture(Colour, Deep)
// Many coats of clear lacquer over a colour: deep in the middle, a mirror at the rims.
// Colour, Deep: of the rims and of the middle; Deep is darker.
// Example: sphere { 0, 1 LacquerTexture(rgb <0.55, 0.02, 0.012>, rgb <0.28, 0.006, 0.004>) }
#macro LacquerTexture(Colour, Deep)
  texture {
    pigment { aoi color_map { [0.5 color Colour] [0.9 color Deep] } }
    finish {
      ambient 0.06 diffuse 0.6 specular albedo 0.05 roughness 0.0012
      reflection { 0.045, 0.4 falloff 5 }
    }
  }
#end

// MetallicPaint(Colour, Flop)
// Car paint: flakes that glitter under clear lacquer, another colour at the rims. Flakes need 16 samples a pixel.
// Colour, Flop: seen straight on and at grazing angles.
// Example: sphere { 0, 1 MetallicPaint(rgb <0.10, 0.22, 0.55>, rgb <0.02, 0.03, 0.12>) }
#macro MetallicPaint(Colour, Flop)
  texture {
    pigment {
      aoi
      pigment_map {
        [0.5 color Flop]
        [0.85 crackle solid color_map { [0.2 color 0.75*Colour] [0.7 color 1.15*Colour] } scale 0.012]
      }
    }
    finish {
      ambient 0.05 diffuse 0.55 brilliance 2.2
      specular albedo 0.16 roughness 0.05 metallic 0.85
      phong albedo 0.04 phong_size 900
      reflection { 0.05, 0.4 falloff 5 }
    }
  }
#end

// PearlPaint(Colour, Shift)
// Pearlescent: turns to another hue where it is seen at an angle, silky.
// Colour, Shift: seen straight on and at an angle.
// Example: sphere { 0, 1 PearlPaint(rgb <0.75, 0.60, 0.72>, rgb <0.35, 0.55, 0.75>) }
#macro PearlPaint(Colour, Shift)
  texture {
    pigment { aoi color_map { [0.5 color 0.7*Shift] [0.66 color Shift] [0.92 color Colour] } }
    finish {
      ambient 0.07 diffuse 0.6 specular albedo 0.14 roughness 0.04 metallic 0.4
      reflection { 0.04, 0.35 falloff 4 } irid { 0.12 thickness 0.5 }
    }
  }
#end

// SiliconeTexture(Colour)
// Translucent rubber: soft shadows, glowing rims, a blurred highlight.
// Example: sphere { 0, 1 SiliconeTexture(rgb <0.75, 0.55, 0.5>) }
#macro SiliconeTexture(Colour)
  texture {
    pigment { aoi color_map { [0.5 color 0.75*Colour + <0.22, 0.22, 0.22, 0, 0>] [0.65 color 1.08*Colour]
      [0.85 color Colour] } }
    finish { WaxFinish specular albedo 0.045 roughness 0.035 }
  }
#end

// ClearResin(Colour, Depth)
// Cast resin and sweets: clear, coloured through, with sharp highlights. A material, for whole bodies.
// Colour: what is left of white light after the way Depth, each component above 0. Depth: about the thickness, in
// units.
// Example: sphere { 0, 1 ClearResin(rgb <0.9, 0.25, 0.3>, 1.5) }
#macro ClearResin(Colour, Depth)
  #local Any_ = <0, 0, 0> + Colour;
  #local Loss_ =
    <-ln(max(0.002, min(1, Any_.red))), -ln(max(0.002, min(1, Any_.green))), -ln(max(0.002, min(1, Any_.blue)))>;
  #local Most_ = max(0.001, Loss_.x, Loss_.y, Loss_.z);
  material {
    texture {
      pigment { rgbf <0.8 + 0.2*Any_.red, 0.8 + 0.2*Any_.green, 0.8 + 0.2*Any_.blue, 0.88> }
      finish { ambient 0.05 diffuse 0.6 specular albedo 0.045 roughness 0.003
        reflection { 0, 0.6 fresnel } conserve_energy }
    }
    // The exponential law; see Glass_Isl_Interior in glass.isl.
    interior { ior 1.42 caustics 0.3 fade_power 1001 fade_distance Depth/Most_ fade_color rgb 1 - Loss_/Most_ }
  }
#end

// ---- Plastics -------------------------------------------------------------------------------------------------------

// ToyRed: texture. Hard plastic in the red of building blocks.
#declare ToyRed = HardPlastic(rgb <0.62, 0.018, 0.016>)
// ToyBlue: texture. Hard plastic, blue.
#declare ToyBlue = HardPlastic(rgb <0.015, 0.10, 0.48>)
// ToyYellow: texture. Hard plastic, yellow.
#declare ToyYellow = HardPlastic(rgb <0.78, 0.50, 0.012>)
// ToyGreen: texture. Hard plastic, green.
#declare ToyGreen = HardPlastic(rgb <0.025, 0.30, 0.05>)
// WhitePlastic: texture. Hard plastic, white.
#declare WhitePlastic = HardPlastic(rgb <0.78, 0.78, 0.77>)
// VinylOrange: texture. Soft, matt: a toy figure.
#declare VinylOrange = SoftPlastic(rgb <0.78, 0.24, 0.035>)
// VinylMint: texture. Soft, matt, pale green.
#declare VinylMint = SoftPlastic(rgb <0.30, 0.66, 0.48>)
// Bakelite: texture. The brown of old telephones, marbled.
#declare Bakelite = texture {
  pigment {
    marble turbulence 0.9 octaves 4
    color_map { [0.2 rgb <0.045, 0.012, 0.006>] [0.6 rgb <0.13, 0.032, 0.012>] [0.95 rgb <0.26, 0.085, 0.03>] }
    scale 0.45 rotate 40
  }
  finish { GlossyFinish(0.9) }
}
// FoamSponge: texture. Soft packing foam, pale yellow, with small pores.
#declare FoamSponge = texture {
  pigment { crackle form <1, 0, 0> color_map { [0.1 rgb <0.42, 0.34, 0.16>]
    [0.35 rgb <0.80, 0.72, 0.45>] } scale 0.045 }
  normal { crackle 0.7 form <1, 0, 0> accuracy 0.02 slope_map { [0 <0, 0>] [0.4 <1, 1>] [1 <1, 0>] } scale 0.045 }
  finish { DustFinish }
}
// MilkySilicone: texture. Translucent rubber, nearly white.
#declare MilkySilicone = SiliconeTexture(rgb <0.66, 0.68, 0.68>)
// RoseSilicone: texture. Translucent rubber, rose.
#declare RoseSilicone = SiliconeTexture(rgb <0.70, 0.30, 0.30>)

// ---- Rubber ---------------------------------------------------------------------------------------------------------

// BlackRubber: texture. Tyres and seals.
#declare BlackRubber = RubberTexture(rgb <0.018, 0.018, 0.019>)
// RedRubber: texture. Hot-water bottles.
#declare RedRubber = RubberTexture(rgb <0.36, 0.055, 0.04>)
// BalloonSkin: texture. Stretched thin: shining, lighter at its rims.
#declare BalloonSkin = texture {
  pigment { aoi color_map { [0.5 rgb <0.80, 0.22, 0.30>] [0.62 rgb <0.70, 0.05, 0.11>]
    [0.9 rgb <0.52, 0.015, 0.045>] } }
  finish { GlossyFinish(0.9) }
}

// ---- Lacquer and paint ----------------------------------------------------------------------------------------------

// RedLacquer: texture. Many coats, as on boxes from the far east.
#declare RedLacquer = LacquerTexture(rgb <0.56, 0.035, 0.015>, rgb <0.30, 0.008, 0.005>)
// BlackLacquer: texture. Pianos.
#declare BlackLacquer = LacquerTexture(rgb 0.012, rgb 0.004)
// MidnightLacquer: texture. Blue black.
#declare MidnightLacquer = LacquerTexture(rgb <0.02, 0.05, 0.16>, rgb <0.004, 0.009, 0.045>)
// BlueCarPaint: texture. Metallic blue.
#declare BlueCarPaint = MetallicPaint(rgb <0.07, 0.22, 0.62>, rgb <0.012, 0.02, 0.12>)
// SilverCarPaint: texture. Metallic silver.
#declare SilverCarPaint = MetallicPaint(rgb <0.55, 0.56, 0.57>, rgb <0.16, 0.17, 0.19>)
// CandyApplePaint: texture. Red glaze over metal.
#declare CandyApplePaint = MetallicPaint(rgb <0.62, 0.02, 0.02>, rgb <0.12, 0.002, 0.008>)
// PearlWhite: texture. White that turns to rose and blue.
#declare PearlWhite = PearlPaint(rgb <0.80, 0.76, 0.74>, rgb <0.62, 0.70, 0.82>)
// ChameleonPaint: texture. Violet straight on, green at an angle.
#declare ChameleonPaint = PearlPaint(rgb <0.28, 0.05, 0.42>, rgb <0.02, 0.36, 0.24>)
// ChippedPaint: texture. Blue green paint that has come off old metal.
#declare ChippedPaint = texture {
  granite
  texture_map {
    [0.52 pigment { bozo color_map { [0.3 rgb <0.05, 0.25, 0.26>] [0.8 rgb <0.085, 0.31, 0.31>] } scale 0.7 }
      finish { GlossyFinish(0.6) }]
    [0.535 pigment { rgb <0.45, 0.42, 0.36> } finish { MatteFinish }]
    [0.55 pigment { granite color_map { [0.2 rgb <0.10, 0.04, 0.02>]
      [0.8 rgb <0.30, 0.13, 0.055>] } scale 0.4 } normal { granite 0.3 accuracy 0.01 scale 0.2 } finish { MatteFinish }]
  }
  scale 0.75
}

// ---- Clear ----------------------------------------------------------------------------------------------------------

// RaspberryGummy: material. Sweets.
#declare RaspberryGummy = ClearResin(rgb <0.72, 0.02, 0.06>, 0.55)
// LimeGummy: material. Sweets.
#declare LimeGummy = ClearResin(rgb <0.32, 0.72, 0.03>, 0.6)
// BlueResin: material. Poured into rivers of wood.
#declare BlueResin = ClearResin(rgb <0.02, 0.25, 0.60>, 0.7)

#version Plastics_Isl_Before;
#end
