// Glass, water, ice, gems and resins: materials that light goes through.
//
//   #include "glass.isl"
//   sphere { 0, 1 material { ClearGlass } }
//   sphere { 0, 1 BottleGlass(rgb <0.1, 0.6, 0.3>, 1) }
//
// All are materials, because they have an interior; in a blob the material belongs to the whole, not to its
// components. Colour comes from the way through the body, so that thin parts are pale and thick ones deep, as in real
// glass: Depth is the way after which only the colour itself is left of white. Those that are declared are made for
// objects about 2 units large; for others take the macros with a Depth in proportion, because scaling a material does
// not scale its interior. global_settings { max_trace_level 12 } lets light through several walls. Clear glass then
// costs some twelve times as much as a plain colour, and six times that where it parts light into colours (LeadCrystal,
// DiamondGem).
#ifndef (Glass_Isl_Before)
#declare Glass_Isl_Before = version;
#version 3.7;
#include "finishes.isl"

// ---- Macros ---------------------------------------------------------------------------------------------------------

// The interior with which light that has gone Depth through the body is multiplied by Colour. `fade_power 1001` is the
// exponential law: what is left of a channel after the way s is exp(-(1 - C) s/D) for the fade_color C. So 1 - C has
// to be proportional to -ln(Colour).
#macro Glass_Isl_Interior(Colour, Depth, Ior, Caustics, Fire)
  #local Any_ = <0, 0, 0> + Colour;
  #local Loss_ =
    <-ln(max(0.002, min(1, Any_.red))), -ln(max(0.002, min(1, Any_.green))), -ln(max(0.002, min(1, Any_.blue)))>;
  #local Most_ = max(0.001, Loss_.x, Loss_.y, Loss_.z);
  interior {
    ior Ior
    caustics Caustics
    fade_power 1001
    fade_distance Depth/Most_
    fade_color rgb 1 - Loss_/Most_
    #if (Fire > 1)
      dispersion Fire
      dispersion_samples 7
    #end
  }
#end

// BottleGlass(Colour, Depth)
// Coloured glass: pale where it is thin, deep where it is thick.
// Colour: what is left of white light after the way Depth, each component above 0. Depth: in units; about the
// thickness.
// Example: sphere { 0, 1 BottleGlass(rgb <0.15, 0.65, 0.35>, 1) }
#macro BottleGlass(Colour, Depth)
  material {
    texture { pigment { rgbf <0.99, 0.99, 0.99, 1> } finish { GlassFinish } }
    Glass_Isl_Interior(Colour, Depth, 1.5, 0.4, 1)
  }
#end

// GemStone(Colour, Depth, Ior, Fire)
// A jewel: coloured, bright, with rainbows where Fire is above 1. Fire costs a path for each of seven colours.
// Colour, Depth: as in BottleGlass. Ior: 1.54 quartz, 1.6 emerald, 1.77 ruby, 2.42 diamond. Fire: 1 none, 1.02 usual.
// Example: sphere { 0, 1 GemStone(rgb <0.7, 0.05, 0.1>, 1, 1.77, 1) }
#macro GemStone(Colour, Depth, Ior, Fire)
  material {
    texture { pigment { rgbf 1 } finish { GlassFinish specular albedo 0.08 } }
    Glass_Isl_Interior(Colour, Depth, Ior, 0.6, Fire)
  }
#end

// FrostedGlass(Colour, Depth, Roughness)
// Etched glass that blurs what is behind it; its grain needs 16 samples a pixel or more.
// Colour, Depth: as in BottleGlass. Roughness: 0.05 breathed upon, 0.2 etched, 0.4 sand-blasted.
// Example: sphere { 0, 1 FrostedGlass(rgb <0.6, 0.85, 0.9>, 1.5, 0.2) }
#macro FrostedGlass(Colour, Depth, Roughness)
  material {
    texture {
      pigment { rgbft <0.95, 0.97, 1, 0.82, 0> }
      normal { bumps 1.2*Roughness scale 0.006 }
      finish { ambient 0.02 diffuse 0.6 specular albedo 0.05 roughness 0.08
        reflection { 0, 0.3 fresnel } conserve_energy }
    }
    Glass_Isl_Interior(Colour, Depth, 1.45, 0, 1)
  }
#end

// MilkGlass(Colour, Clear)
// Glass that scatters light inside, between porcelain and glass; a component of a blob may have it, too.
// Clear: share of the light that goes through, 0.1 to 0.6.
// Example: sphere { 0, 1 MilkGlass(rgb <0.75, 0.85, 0.95>, 0.3) }
#macro MilkGlass(Colour, Clear)
  #local Any_ = <0, 0, 0> + Colour;
  material {
    texture {
      pigment {
        aoi
        color_map {
          [0.5 rgbf <Any_.red, Any_.green, Any_.blue, 0.3*Clear>]
          [1 rgbf <Any_.red, Any_.green, Any_.blue, Clear>]
        }
      }
      finish { ambient 0.06 diffuse 0.56 brilliance 0.6 specular albedo 0.04 roughness 0.002
        reflection { 0.03, 0.3 falloff 5 } }
    }
    interior { ior 1.25 }
  }
#end

// SoapFilm(Thickness)
// A bubble: nothing but a thin skin with the colours of its film, strongest at the rim.
// Thickness: 0.5 few wide bands … 2 many narrow ones.
// Example: sphere { 0, 1 SoapFilm(1) }
#macro SoapFilm(Thickness)
  material {
    texture {
      pigment { rgbt <1, 1, 1, 1> }
      finish {
        ambient 0 diffuse 0 specular albedo 0.15 roughness 0.002
        reflection { 0.06, 0.85 falloff 2.5 }
        irid { 0.7 thickness Thickness turbulence 0.35 }
        conserve_energy
      }
    }
    interior { ior 1 }
  }
#end

// ---- Glass ----------------------------------------------------------------------------------------------------------

// ClearGlass: material. Window glass, a breath of green in its depth.
#declare ClearGlass = BottleGlass(rgb <0.90, 0.96, 0.93>, 2)
// LeadCrystal: material. Heavy cut glass that parts light into colours.
#declare LeadCrystal = GemStone(rgb <0.97, 0.98, 0.99>, 3, 1.62, 1.03)
// GreenBottle: material. The green of wine bottles.
#declare GreenBottle = BottleGlass(rgb <0.12, 0.55, 0.17>, 1.2)
// BrownBottle: material. The brown of medicine and beer.
#declare BrownBottle = BottleGlass(rgb <0.50, 0.19, 0.03>, 1)
// CobaltGlass: material. Deep blue.
#declare CobaltGlass = BottleGlass(rgb <0.03, 0.09, 0.62>, 1)
// RubyGlass: material. Red with gold, as in old windows.
#declare RubyGlass = BottleGlass(rgb <0.72, 0.025, 0.05>, 1)
// AquaGlass: material. The pale blue green of old fishing floats.
#declare AquaGlass = BottleGlass(rgb <0.25, 0.75, 0.72>, 1.6)
// RoseGlass: material. Pale pink.
#declare RoseGlass = BottleGlass(rgb <0.92, 0.42, 0.48>, 1.6)
// SmokedGlass: material. Grey, as of lamps and tables.
#declare SmokedGlass = BottleGlass(rgb <0.20, 0.18, 0.17>, 1.4)
// EtchedGlass: material. Blurs what is behind it.
#declare EtchedGlass = FrostedGlass(rgb <0.86, 0.94, 0.95>, 2, 0.2)
// SeaGlass: material. Shards that the sea has rounded and clouded, green blue.
#declare SeaGlass = FrostedGlass(rgb <0.22, 0.72, 0.56>, 1.6, 0.35)
// OpalGlass: material. White glass that glows at its edges.
#declare OpalGlass = MilkGlass(rgb <0.86, 0.90, 0.95>, 0.35)
// SoapBubble: material. A film with all colours.
#declare SoapBubble = SoapFilm(1.1)

// ---- Water and ice --------------------------------------------------------------------------------------------------

// ClearWater: material. Drops and glasses of water.
#declare ClearWater = material {
  texture { pigment { rgbf 1 } finish { GlassFinish } }
  Glass_Isl_Interior(rgb <0.82, 0.94, 0.97>, 3, 1.33, 0.8, 1)
}
// LagoonWater: material. Turquoise with depth, with small waves.
#declare LagoonWater = material {
  texture { pigment { rgbf 1 } normal { bumps 0.12 scale <0.3, 0.3, 0.2> } finish { GlassFinish } }
  Glass_Isl_Interior(rgb <0.05, 0.55, 0.60>, 1.6, 1.33, 0.8, 1)
}
// IceBlock: material. Ice with cracks and a cold heart.
#declare IceBlock = material {
  texture {
    pigment { granite color_map { [0.3 rgbf <0.96, 0.99, 1, 0.97>] [0.62 rgbf <0.94, 0.98, 1, 0.8>]
      [0.8 rgbf <1, 1, 1, 0.35>] } scale 0.9 }
    normal { dents 0.5 scale 0.25 }
    finish { ambient 0.03 diffuse 0.5 specular albedo 0.05 roughness 0.004
      reflection { 0, 0.5 fresnel } conserve_energy }
  }
  Glass_Isl_Interior(rgb <0.35, 0.72, 0.85>, 1.8, 1.31, 0.3, 1)
}
// GlacierIce: material. Old ice without air: blue, and clouded at its skin.
#declare GlacierIce = material {
  texture {
    pigment { bozo turbulence 0.4 octaves 4 color_map { [0.3 rgbf <0.9, 0.97, 1, 0.85>]
      [0.7 rgbf <0.85, 0.95, 1, 0.5>] } scale 0.5 }
    normal { wrinkles 0.35 scale 0.4 }
    finish { ambient 0.04 diffuse 0.6 specular albedo 0.05 roughness 0.01
      reflection { 0, 0.4 fresnel } conserve_energy }
  }
  Glass_Isl_Interior(rgb <0.08, 0.45, 0.72>, 1.4, 1.31, 0.2, 1)
}

// ---- Gems and resins ------------------------------------------------------------------------------------------------

// RubyGem: material. Red.
#declare RubyGem = GemStone(rgb <0.60, 0.02, 0.07>, 1, 1.77, 1)
// EmeraldGem: material. Green.
#declare EmeraldGem = GemStone(rgb <0.03, 0.50, 0.18>, 1, 1.58, 1)
// SapphireGem: material. Blue.
#declare SapphireGem = GemStone(rgb <0.04, 0.10, 0.60>, 1, 1.77, 1)
// AmethystGem: material. Violet.
#declare AmethystGem = GemStone(rgb <0.36, 0.10, 0.55>, 1, 1.55, 1)
// TopazGem: material. Honey gold.
#declare TopazGem = GemStone(rgb <0.85, 0.45, 0.08>, 1.2, 1.62, 1)
// DiamondGem: material. Clear, with fire.
#declare DiamondGem = GemStone(rgb 0.98, 4, 2.42, 1.03)
// AmberResin: material. Fossil resin: honey, with clouds and sparks inside.
#declare AmberResin = material {
  texture {
    pigment { granite turbulence 0.3 color_map { [0.35 rgbf <1, 0.9, 0.7, 0.96>]
      [0.7 rgbf <1, 0.75, 0.4, 0.72>] } scale 1.1 }
    finish { ambient 0.03 diffuse 0.5 specular albedo 0.045 roughness 0.002
      reflection { 0, 0.6 fresnel } conserve_energy }
  }
  Glass_Isl_Interior(rgb <0.80, 0.28, 0.02>, 1.2, 1.54, 0.5, 1)
}
// HoneySyrup: material. Liquid gold, thick.
#declare HoneySyrup = BottleGlass(rgb <0.84, 0.36, 0.015>, 0.9)

#version Glass_Isl_Before;
#end
