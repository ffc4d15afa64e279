// Metals: polished, satin, brushed, hammered, cast, and what time does to them.
//
//   #include "metals.isl"
//   sphere { 0, 1 texture { PolishedGold } }
//   sphere { 0, 1 SatinMetal(CopperTint) }
//
// Metals show what is around them: give them a sky (StudioSky of skies.isl) and a floor, or they are black. Grains are
// made for objects about 2 units large; scale the texture with the object. The tints are near to
// what clean metal mirrors seen straight on, in linear light, and a little more colourful, as metal is in its own
// folds.
#ifndef (Metals_Isl_Before)
#declare Metals_Isl_Before = version;
#version 3.7;
#include "finishes.isl"

// ---- Tints ----------------------------------------------------------------------------------------------------------

// GoldTint: colour. Fine gold.
#declare GoldTint = rgb <1.00, 0.69, 0.25>;
// RoseGoldTint: colour. Gold with copper.
#declare RoseGoldTint = rgb <0.97, 0.60, 0.42>;
// WhiteGoldTint: colour. Gold with palladium.
#declare WhiteGoldTint = rgb <0.86, 0.80, 0.68>;
// SilverTint: colour. Silver, the brightest of all.
#declare SilverTint = rgb <0.97, 0.96, 0.92>;
// CopperTint: colour. Copper.
#declare CopperTint = rgb <0.95, 0.52, 0.36>;
// BrassTint: colour. Brass.
#declare BrassTint = rgb <0.89, 0.70, 0.31>;
// BronzeTint: colour. Bronze, as statues have it.
#declare BronzeTint = rgb <0.66, 0.40, 0.20>;
// SteelTint: colour. Steel and iron.
#declare SteelTint = rgb <0.56, 0.57, 0.58>;
// ChromeTint: colour. Chrome.
#declare ChromeTint = rgb <0.66, 0.68, 0.70>;
// AluminiumTint: colour. Aluminium.
#declare AluminiumTint = rgb <0.91, 0.92, 0.92>;
// TitaniumTint: colour. Titanium.
#declare TitaniumTint = rgb <0.55, 0.51, 0.46>;
// PewterTint: colour. Tin and pewter.
#declare PewterTint = rgb <0.60, 0.58, 0.54>;

// ---- Any metal ------------------------------------------------------------------------------------------------------

// PolishedMetal(Colour)
// A mirror of metal.
// Colour: the tint, in linear light.
// Example: sphere { 0, 1 PolishedMetal(GoldTint) }
#macro PolishedMetal(Colour)
  texture { pigment { color Colour } finish { MetalFinish(1) } }
#end

// SatinMetal(Colour)
// A fine grain that blurs what it mirrors, the same in all directions.
// Example: sphere { 0, 1 SatinMetal(SilverTint) }
#macro SatinMetal(Colour)
  texture {
    pigment { color Colour }
    normal { bumps 0.13 scale 0.004 }
    finish { MetalFinish(0.62) }
  }
#end

// BrushedMetal(Colour, Along)
// Fine scratches in one direction, across which lights are drawn out.
// Along: the direction of the scratches.
// Example: sphere { 0, 1 BrushedMetal(SteelTint, x) }
#macro BrushedMetal(Colour, Along)
  #local To_ = vnormalize(Along);
  #local Side_ = vnormalize(vcross(To_, (abs(To_.y) < 0.9 ? y : x)));
  #local Up_ = vcross(To_, Side_);
  texture {
    pigment {
      bozo color_map { [0.3 Colour*0.9] [0.7 color Colour] }
      scale <1.6, 0.014, 0.014>
      matrix <To_.x, To_.y, To_.z, Side_.x, Side_.y, Side_.z, Up_.x, Up_.y, Up_.z, 0, 0, 0>
    }
    normal {
      // Flattened along the scratches instead of stretched: a stretch would tilt the normals on every slope.
      bumps 0.11
      warp { planar x, 0 }
      scale 0.006
      matrix <To_.x, To_.y, To_.z, Side_.x, Side_.y, Side_.z, Up_.x, Up_.y, Up_.z, 0, 0, 0>
    }
    finish { MetalFinish(0.66) }
  }
#end

// HammeredMetal(Colour, Size)
// The dents of a hammer, side by side.
// Size: of a dent, in units; 0.2 on an object 2 units large.
// Example: sphere { 0, 1 HammeredMetal(CopperTint, 0.2) }
#macro HammeredMetal(Colour, Size)
  texture {
    pigment { color Colour }
    normal {
      crackle 0.55 form <1.1, 0, 0>
      slope_map { [0 <0, 0>] [0.6 <0.7, 1>] [1 <1, 0>] }
      accuracy 0.01 scale Size
    }
    finish { MetalFinish(0.9) }
  }
#end

// CastMetal(Colour)
// Rough from the mould, without a shine.
// Example: sphere { 0, 1 CastMetal(SteelTint) }
#macro CastMetal(Colour)
  texture {
    pigment { granite color_map { [0 Colour*0.3] [0.7 Colour*0.75] } scale 0.4 }
    normal { granite 0.25 accuracy 0.006 scale 0.15 }
    finish { MetalFinish(0.05) }
  }
#end

// OxidisedMetal(Metal, Crust, Amount)
// A texture of metal with another that grows on it in patches, first where the surface faces up and rain stays.
// Metal, Crust: textures of one layer each. Amount: 0 none, 0.5 half, 1 all.
// Example: sphere { 0, 1 OxidisedMetal(PolishedCopper, Verdigris, 0.5) }
#macro OxidisedMetal(Metal, Crust, Amount)
  texture {
    pigment_pattern {
      average
      pigment_map {
        [1 slope { y, 0.1, 0.9 } color_map { [0 rgb 0] [1 rgb 1] }]
        [2 granite color_map { [0.05 rgb 0] [0.65 rgb 1] } scale 0.7]
      }
    }
    texture_map { [0.98*(1 - Amount) - 0.02 Metal] [0.98*(1 - Amount) + 0.06 Crust] }
  }
#end

// ---- Declared metals ------------------------------------------------------------------------------------------------

// PolishedGold: texture. A mirror of fine gold.
#declare PolishedGold = PolishedMetal(GoldTint)
// SatinGold: texture. Gold with a fine, soft grain, as of jewellery.
#declare SatinGold = SatinMetal(GoldTint)
// HammeredGold: texture. Beaten gold, every dent a small mirror.
#declare HammeredGold = HammeredMetal(GoldTint, 0.16)
// GoldLeaf: texture. Thin leaf that creases and lets red ground through where it is torn.
#declare GoldLeaf = texture {
  pigment_pattern { granite scale 0.8 }
  texture_map {
    [0.52 pigment { GoldTint } normal { wrinkles 0.35 scale 0.35 } finish { MetalFinish(0.75) }]
    [0.56 pigment { rgb <0.26, 0.055, 0.03> } normal { wrinkles 0.35 scale 0.35 } finish { EggshellFinish }]
  }
}
// RoseGold: texture. A mirror of gold and copper.
#declare RoseGold = PolishedMetal(RoseGoldTint)
// PolishedSilver: texture. The brightest mirror.
#declare PolishedSilver = PolishedMetal(SilverTint)
// TarnishedSilver: texture. Old silver: dark with sulphide, bright where hands wipe it.
#declare TarnishedSilver = texture {
  pigment_pattern { bozo turbulence 0.5 octaves 4 scale 0.6 }
  texture_map {
    [0.3 pigment { SilverTint*0.92 } finish { MetalFinish(0.9) }]
    [0.62 pigment { rgb <0.42, 0.36, 0.26> } finish { MetalFinish(0.65) }]
    [0.85 pigment { rgb <0.11, 0.10, 0.12> } finish { MetalFinish(0.45) }]
  }
}
// PolishedCopper: texture. A mirror of copper.
#declare PolishedCopper = PolishedMetal(CopperTint)
// HammeredCopper: texture. A beaten kettle.
#declare HammeredCopper = HammeredMetal(CopperTint, 0.24)
// PolishedBrass: texture. Brass as of horns and handles.
#declare PolishedBrass = PolishedMetal(BrassTint)
// BrushedBrass: texture. Brass with scratches along x.
#declare BrushedBrass = BrushedMetal(BrassTint, x)
// DarkBronze: texture. A statue: brown, waxed, brighter at the touch of light.
#declare DarkBronze = texture {
  pigment {
    granite color_map { [0.1 rgb <0.20, 0.095, 0.04>] [0.8 rgb <0.42, 0.23, 0.10>] } scale 0.9
  }
  normal { bumps 0.06 scale 0.06 }
  finish { MetalFinish(0.55) }
}
// Verdigris: texture. The green crust of copper and bronze.
#declare Verdigris = texture {
  pigment {
    granite
    color_map { [0.1 rgb <0.07, 0.21, 0.17>] [0.45 rgb <0.16, 0.40, 0.32>] [0.75 rgb <0.38, 0.60, 0.48>] }
    scale 0.6
  }
  normal { granite 0.2 accuracy 0.008 scale 0.25 }
  finish { MatteFinish }
}
// GreenBronze: texture. Bronze that rain has turned green on its upper sides.
#declare GreenBronze = OxidisedMetal(DarkBronze, Verdigris, 0.52)
// MirrorChrome: texture. Chrome, cool and dark between its lights.
#declare MirrorChrome = PolishedMetal(ChromeTint)
// BrushedSteel: texture. Steel with scratches along x.
#declare BrushedSteel = BrushedMetal(SteelTint*1.15, x)
// BeadedSteel: texture. Blasted with glass beads: a soft, even grey.
#declare BeadedSteel = SatinMetal(SteelTint*1.1)
// BrushedAluminium: texture. Pale, with scratches along x.
#declare BrushedAluminium = BrushedMetal(AluminiumTint*0.9, x)
// CastIron: texture. Dark and rough from the mould.
#declare CastIron = CastMetal(SteelTint*0.45)
// RustCrust: texture. Iron oxide, from nearly black over orange to ochre.
#declare RustCrust = texture {
  pigment {
    granite turbulence 0.2 octaves 3
    color_map {
      [0.1 rgb <0.06, 0.022, 0.014>] [0.35 rgb <0.20, 0.065, 0.022>] [0.55 rgb <0.36, 0.13, 0.04>]
        [0.8 rgb <0.50, 0.25, 0.09>] }
    scale 0.7
  }
  normal { granite 0.5 accuracy 0.008 scale 0.25 }
  finish { MatteFinish }
}
// RustySteel: texture. Steel that rust eats from above.
#declare RustySteel = OxidisedMetal(BeadedSteel, RustCrust, 0.5)
// HeatTintedTitanium: texture. Titanium from the flame: straw, purple and blue that turn with the angle.
#declare HeatTintedTitanium = texture {
  pigment {
    aoi
    color_map {
      [0.5 rgb <0.30, 0.55, 0.62>] [0.62 rgb <0.10, 0.22, 0.62>] [0.74 rgb <0.30, 0.12, 0.55>]
        [0.84 rgb <0.66, 0.26, 0.36>]
      [0.93 rgb <0.80, 0.56, 0.24>] [1 rgb <0.72, 0.62, 0.40>] }
  }
  finish { MetalFinish(0.85) }
}
// BlackNickel: texture. Almost black, a dark mirror.
#declare BlackNickel = PolishedMetal(rgb <0.19, 0.18, 0.17>)
// MeltedLead: texture. Dull blue grey, with a skin that creases.
#declare MeltedLead = texture {
  pigment { bozo color_map { [0.3 rgb <0.27, 0.29, 0.33>] [0.7 rgb <0.40, 0.41, 0.43>] } scale 0.4 }
  normal { wrinkles 0.3 scale 0.4 }
  finish { MetalFinish(0.5) }
}

#version Metals_Isl_Before;
#end
