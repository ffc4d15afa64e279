// Skins: corals, shells, mosses, waxes, bones, chitin, eyes, flesh and jelly, for what is grown of blobs.
//
//   #include "skins.isl"
//   blob { … texture { RedCoral } }
//   blob { … texture { FrogSkin scale 0.5 } }
//   sphere { 0, 1 EyeTexture(rgb <0.1, 0.35, 0.5>, 0.4) scale 0.2 }
//
// Skins are made for bodies about 2 units large; scale the texture with the body. Several follow the shape instead of
// space: what faces up (y), and the rims, where the surface is seen at a grazing angle, as if light went through thin
// edges. They may be components' textures, so that a coral goes from one to another along its branches.
#ifndef (Skins_Isl_Before)
#declare Skins_Isl_Before = version;
#version 3.7;
#include "finishes.isl"

// ---- Macros ---------------------------------------------------------------------------------------------------------

// RimPigment(Middle, Rim)
// A pigment that goes from one colour to another towards the outline, soft as light through skin.
// Middle, Rim: colours; a Rim lighter and more colourful than the Middle looks translucent, a darker one velvety.
// Example: sphere { 0, 1 pigment { RimPigment(rgb <0.6, 0.25, 0.15>, rgb <0.9, 0.5, 0.3>) } }
#macro RimPigment(Middle, Rim)
  aoi
  color_map {
    [0.5 color Rim]
    [0.62 color 0.6*Rim + 0.4*Middle]
    [0.78 color Middle]
  }
#end

// CoralTexture(Colour, Tip, Size)
// A stony coral: little cups side by side, each with a pale rim; what faces up, where it grows, is of the colour of
// its tips.
// Colour, Tip: of the body and of the tips. Size: of a cup, in units; 0.06 on a body 2 units large.
// Example: sphere { 0, 1 CoralTexture(rgb <0.62, 0.10, 0.07>, rgb <0.95, 0.62, 0.48>, 0.08) }
#macro CoralTexture(Colour, Tip, Size)
  #local Body_ = <0, 0, 0> + Colour;
  #local Tip_ = <0, 0, 0> + Tip;
  #local C_ = <Body_.red, Body_.green, Body_.blue>;
  #local T_ = <Tip_.red, Tip_.green, Tip_.blue>;
  texture {
    pigment {
      slope y
      pigment_map {
        [0.4 crackle form <1, 0, 0> color_map { [0.08 rgb 0.3*C_] [0.3 rgb 0.75*C_] [0.7 rgb 0.92*C_ + 0.05*T_] }
          scale Size]
        [1 crackle form <1, 0, 0> color_map { [0.08 rgb 0.7*C_] [0.3 rgb 0.7*C_ + 0.3*T_] [0.7 rgb 0.3*C_ + 0.7*T_] }
          scale Size]
      }
    }
    normal {
      crackle 0.6 form <1, 0, 0> accuracy 0.01
      slope_map { [0 <0, 0>] [0.15 <0, 1>] [0.45 <1, 0.5>] [1 <0.8, 0>] }
      scale Size
    }
    finish { FleshFinish }
  }
#end

// MossOver(Base, Amount)
// A texture with moss on what faces up.
// Base: a texture of one layer. Amount: 0 none, 0.5 what faces up, 0.8 nearly all.
// Example: sphere { 0, 1 MossOver(OldBone, 0.5) }
#macro MossOver(Base, Amount)
  texture {
    pigment_pattern {
      average
      pigment_map {
        [2 slope y color_map { [0 rgb 0] [1 rgb 1] }]
        [0.6 granite color_map { [0.1 rgb 0] [0.6 rgb 1] } scale 0.6]
      }
    }
    texture_map { [0.96*(1 - Amount) Base] [0.96*(1 - Amount) + 0.05 CushionMoss] }
  }
#end

// ScaleSkin(Colour, Edge, Size, Gloss)
// Scales that touch one another: lizards, snakes, fish, dragons.
// Colour, Edge: of a scale's middle and of the skin between. Size: of a scale, in units; 0.1. Gloss: as in
// GlossyFinish.
// Example: sphere { 0, 1 ScaleSkin(rgb <0.16, 0.32, 0.08>, rgb <0.03, 0.05, 0.02>, 0.12, 0.6) }
#macro ScaleSkin(Colour, Edge, Size, Gloss)
  texture {
    pigment {
      crackle
      color_map { [0.02 color Edge] [0.12 color 0.5*Edge + 0.5*Colour] [0.3 color Colour] [0.8 color 1.15*Colour] }
      scale Size
    }
    normal {
      crackle 0.7 accuracy 0.012
      slope_map { [0 <0, 1>] [0.14 <0.7, 1>] [0.4 <1, 0>] [1 <1, 0>] }
      scale Size
    }
    finish { GlossyFinish(Gloss) }
  }
#end

// ChitinShell(Colour, Sheen, Film)
// The armour of beetles: dark lacquer over a colour that turns towards Sheen at the rims, with the colours of a thin
// film.
// Colour, Sheen: colours. Film: strength of the film's colours, 0 none, 0.25 usual, 0.6 jewel beetle.
// Example: sphere { 0, 1 ChitinShell(rgb <0.02, 0.10, 0.05>, rgb <0.30, 0.28, 0.02>, 0.3) }
#macro ChitinShell(Colour, Sheen, Film)
  texture {
    pigment { aoi color_map { [0.5 color Sheen] [0.68 color 0.5*Sheen + 0.5*Colour] [0.9 color Colour] } }
    normal { bumps 0.04 scale 0.03 }
    finish {
      ambient 0.04 diffuse 0.4 brilliance 1.8
      specular albedo 0.3 roughness 0.02 metallic 0.8
      phong albedo 0.02 phong_size 500
      reflection { 0.16, 0.7 falloff 3 metallic 0.75 }
      irid { Film thickness 0.7 }
    }
  }
#end

// EyeTexture(Iris, Pupil)
// A wet eye for a sphere about the origin of any radius R: scale it by R. It looks along -z; turn it with the sphere.
// Iris: its colour. Pupil: width of the pupil as a share of the iris, 0.25 in the sun, 0.6 in the dark.
// Example: sphere { 0, 1 EyeTexture(rgb <0.08, 0.30, 0.42>, 0.4) }
#macro EyeTexture(Iris, Pupil)
  #local Any_ = <0, 0, 0> + Iris;
  #local Iris_ = <Any_.red, Any_.green, Any_.blue>;
  #local Fibres_ = pigment {
    radial frequency 30 triangle_wave
    color_map { [0 rgb 0.55*Iris_] [0.7 rgb 1.1*Iris_] [1 rgb 1.4*Iris_ + <0.07, 0.05, 0.02>] }
    rotate 90*x
    warp { turbulence <0.12, 0.12, 0> octaves 3 }
  }
  texture {
    // The distance from the eye's axis, 1 on it and 0 at the equator.
    pigment {
      cylindrical
      pigment_map {
        [0.36 wrinkles turbulence 0.3 color_map { [0.4 rgb <0.82, 0.76, 0.70>] [0.75 rgb <0.80, 0.66, 0.58>]
          [0.95 rgb <0.62, 0.22, 0.16>] } scale 0.35]
        [0.44 rgb <0.72, 0.64, 0.58>]
        [0.48 rgb 0.10*Iris_]
        [0.54 Fibres_ rotate 90*x]
        [1 - 0.5*Pupil - 0.05 Fibres_ rotate 90*x]
        [1 - 0.5*Pupil - 0.02 rgb 0.25*Iris_]
        [1 - 0.5*Pupil rgb 0.004]
      }
      rotate 90*x
    }
    finish {
      ambient 0.08 diffuse 0.7 brilliance 0.85
      specular albedo 0.045 roughness 0.0015
      reflection { 0.035, 0.3 falloff 5 }
    }
  }
#end

// HumanSkin(Tone)
// Skin: pores, blotches of blood, a rim where light goes through.
// Tone: the colour in linear light; <0.62, 0.36, 0.26> pale, <0.38, 0.19, 0.11> tanned, <0.09, 0.042, 0.024> dark.
// Example: sphere { 0, 1 HumanSkin(rgb <0.62, 0.36, 0.26>) }
#macro HumanSkin(Tone)
  #local Any_ = <0, 0, 0> + Tone;
  #local Tone_ = <Any_.red, Any_.green, Any_.blue>;
  texture {
    pigment {
      aoi
      pigment_map {
        [0.5 rgb Tone_*<1.28, 1.02, 0.95>]
        [0.7 bozo turbulence 0.4 octaves 3 color_map { [0.25 rgb Tone_*<1.04, 1.03, 1.02>] [0.55 rgb Tone_]
          [0.85 rgb Tone_*<1, 0.80, 0.78>] } scale 0.35]
      }
    }
    normal {
      average
      normal_map { [1 crackle 0.25 accuracy 0.02 scale 0.022] [1 bumps 0.16 scale 0.05] }
    }
    finish { ambient 0.09 diffuse 0.84 brilliance 0.7 specular albedo 0.035 roughness 0.07 }
  }
#end

// JellyFlesh(Colour, Clear)
// A clear body that is coloured through: sea jellies, larvae, sweets. Rims are denser than the middle.
// Clear: share of light that goes straight through, 0.3 milky to 0.9 glassy.
// Example: sphere { 0, 1 JellyFlesh(rgb <0.85, 0.35, 0.5>, 0.7) }
#macro JellyFlesh(Colour, Clear)
  #local Any_ = <0, 0, 0> + Colour;
  #local Hue_ = <Any_.red, Any_.green, Any_.blue>;
  material {
    texture {
      pigment {
        aoi
        color_map {
          // Edges are seen through more of the body, and are milky.
          [0.5 rgbft <Hue_.x, Hue_.y, Hue_.z, 0.2*Clear, 0>]
          [0.66 rgbft <Hue_.x, Hue_.y, Hue_.z, 0.62*Clear, 0.1*Clear>]
          [0.88 rgbft <Hue_.x, Hue_.y, Hue_.z, 0.75*Clear, 0.25*Clear>]
        }
      }
      finish { JellyFinish }
    }
    interior { ior 1.08 }
  }
#end

// ---- Corals and sponges ---------------------------------------------------------------------------------------------

// RedCoral: texture. Deep red with pale cups: precious coral.
#declare RedCoral = CoralTexture(rgb <0.52, 0.045, 0.04>, rgb <0.92, 0.40, 0.30>, 0.075)
// OrangeCoral: texture. Sun coral, with yellow tips.
#declare OrangeCoral = CoralTexture(rgb <0.78, 0.20, 0.03>, rgb <1.00, 0.66, 0.22>, 0.09)
// VioletCoral: texture. Sea fans: violet with rosy tips.
#declare VioletCoral = CoralTexture(rgb <0.20, 0.06, 0.30>, rgb <0.78, 0.45, 0.72>, 0.065)
// TealCoral: texture. Acropora: blue green with pale tips.
#declare TealCoral = CoralTexture(rgb <0.03, 0.22, 0.24>, rgb <0.55, 0.84, 0.74>, 0.07)
// BleachedCoral: texture. Dead coral: white, porous.
#declare BleachedCoral = CoralTexture(rgb <0.62, 0.58, 0.50>, rgb <0.86, 0.84, 0.79>, 0.06)
// BrainCoral: texture. Winding ridges and green valleys.
#declare BrainCoral = texture {
  pigment {
    bozo turbulence 0.35 octaves 2 sine_wave frequency 9
    color_map { [0.1 rgb <0.12, 0.16, 0.06>] [0.4 rgb <0.24, 0.23, 0.09>] [0.65 rgb <0.52, 0.40, 0.18>]
      [0.9 rgb <0.66, 0.55, 0.32>] }
    scale 0.24
  }
  normal { bozo 0.6 turbulence 0.35 octaves 2 sine_wave frequency 9 accuracy 0.006 scale 0.24 }
  finish { FleshFinish }
}
// YellowSponge: texture. Soft, full of pores.
#declare YellowSponge = texture {
  pigment {
    crackle form <1, 0, 0>
    color_map { [0.12 rgb <0.08, 0.03, 0.004>] [0.32 rgb <0.52, 0.29, 0.035>] [0.8 rgb <0.78, 0.55, 0.12>] }
    warp { turbulence 0.12 octaves 2 }
    scale 0.13
  }
  normal { crackle 1 form <1, 0, 0> accuracy 0.02 slope_map { [0 <0, 0>] [0.15 <0, 1>] [0.45 <1, 1>]
    [1 <1, 0>] } scale 0.13 }
  finish { DustFinish }
}
// UrchinSkin: texture. Violet black, with rows of pale knobs.
#declare UrchinSkin = texture {
  pigment {
    leopard
    color_map { [0.1 rgb <0.030, 0.010, 0.045>] [0.4 rgb <0.10, 0.03, 0.12>] [0.75 rgb <0.42, 0.25, 0.38>]
      [0.95 rgb <0.72, 0.60, 0.62>] }
    scale 0.026
  }
  normal { leopard 0.5 scale 0.026 }
  finish { SatinFinish }
}
// StarfishSkin: texture. Orange leather with rows of pale warts.
#declare StarfishSkin = texture {
  pigment {
    crackle form <1, 0, 0>
    color_map { [0.14 rgb <0.92, 0.72, 0.46>] [0.24 rgb <0.78, 0.36, 0.10>] [0.6 rgb <0.55, 0.14, 0.03>] }
    scale 0.11
  }
  normal { crackle -0.7 form <1, 0, 0> accuracy 0.01 slope_map { [0 <0, 0.5>] [0.25 <1, 0>] [1 <1, 0>] } scale 0.11 }
  finish { SatinFinish }
}

// ---- Shells ---------------------------------------------------------------------------------------------------------

// SeaShell: texture. Glazed, cream with bands of brown and rose.
#declare SeaShell = texture {
  pigment {
    gradient <0.25, 1, 0.1> turbulence 0.25 octaves 4
    color_map {
      [0 rgb <0.82, 0.70, 0.58>] [0.3 rgb <0.84, 0.74, 0.64>] [0.5 rgb <0.76, 0.50, 0.38>] [0.62 rgb <0.60, 0.28, 0.17>]
        [0.74 rgb <0.42, 0.17, 0.09>] [0.8 rgb <0.78, 0.58, 0.44>] [1 rgb <0.82, 0.70, 0.58>] }
    scale 0.34
  }
  normal { gradient <0.25, 1, 0.1> 0.16 sine_wave turbulence 0.08 accuracy 0.01 scale 0.09 }
  finish { GlossyFinish(0.75) }
}
// MotherOfPearl: texture. The inside of a shell: pale green, rose and blue in folds, which move with the eye.
#declare MotherOfPearl = texture {
  pigment {
    average
    pigment_map {
      [1 aoi color_map {
        [0.5 rgb <0.42, 0.66, 0.85>] [0.6 rgb <0.86, 0.50, 0.70>] [0.72 rgb <0.48, 0.82, 0.62>]
          [0.86 rgb <0.90, 0.78, 0.52>]
        [1 rgb <0.82, 0.66, 0.78>] }]
      [1.5 bozo turbulence 0.7 octaves 3 sine_wave frequency 2.5 color_map {
        [0 rgb <0.50, 0.72, 0.86>] [0.3 rgb <0.92, 0.68, 0.78>] [0.6 rgb <0.62, 0.88, 0.68>]
          [0.8 rgb <0.95, 0.88, 0.66>]
        [1 rgb <0.86, 0.76, 0.90>] } scale <0.7, 0.3, 0.7>]
    }
  }
  normal { bozo 0.12 turbulence 0.5 octaves 3 sine_wave frequency 2.5 scale <0.7, 0.3, 0.7> }
  finish { PearlFinish }
}
// WhitePearl: texture. A single pearl, with a rosy depth.
#declare WhitePearl = texture {
  pigment { aoi color_map { [0.5 rgb <0.62, 0.66, 0.76>] [0.65 rgb <0.84, 0.74, 0.76>] [0.85 rgb <0.88, 0.84, 0.76>]
    [1 rgb <0.90, 0.86, 0.82>] } }
  finish { PearlFinish }
}
// BlackPearl: texture. Dark grey with green and violet.
#declare BlackPearl = texture {
  pigment { aoi color_map { [0.5 rgb <0.20, 0.26, 0.34>] [0.66 rgb <0.18, 0.10, 0.20>] [0.84 rgb <0.07, 0.13, 0.11>]
    [1 rgb <0.09, 0.10, 0.12>] } }
  finish { PearlFinish reflection { 0.07, 0.28 falloff 3 } }
}
// AbaloneShell: texture. Blue and green fire, in folds.
#declare AbaloneShell = texture {
  pigment {
    granite turbulence 0.5 octaves 3
    color_map {
      [0.1 rgb <0.02, 0.08, 0.20>] [0.3 rgb <0.03, 0.32, 0.40>] [0.45 rgb <0.16, 0.50, 0.30>]
        [0.55 rgb <0.58, 0.58, 0.46>]
      [0.65 rgb <0.48, 0.16, 0.40>] [0.8 rgb <0.06, 0.16, 0.36>] }
    scale 1.1
  }
  normal { wrinkles 0.3 scale 0.4 }
  finish { PearlFinish metallic 0.7 irid { 0.35 thickness 0.8 turbulence 0.3 } }
}
// EggShell: texture. A hen's egg: matt, warm, with faint pores.
#declare EggShell = texture {
  pigment { bozo color_map { [0.3 rgb <0.72, 0.50, 0.36>] [0.7 rgb <0.78, 0.58, 0.44>] } scale 0.15 }
  normal { bumps 0.1 scale 0.015 }
  finish { ambient 0.09 diffuse 0.84 brilliance 0.75 specular albedo 0.02 roughness 0.1 }
}
// SpeckledEgg: texture. A wild bird's: blue green with brown spots.
#declare SpeckledEgg = texture {
  pigment {
    dents turbulence 0.3 octaves 3
    color_map { [0.34 rgb <0.28, 0.52, 0.48>] [0.42 rgb <0.30, 0.44, 0.38>] [0.46 rgb <0.09, 0.045, 0.025>]
      [0.7 rgb <0.05, 0.025, 0.015>] }
    scale 0.1
  }
  finish { ambient 0.09 diffuse 0.82 brilliance 0.8 specular albedo 0.03 roughness 0.05 }
}

// ---- Moss, leaves, fungi --------------------------------------------------------------------------------------------

// CushionMoss: texture. Deep, soft, with light tips.
#declare CushionMoss = texture {
  pigment {
    slope y
    pigment_map {
      [0.3 bozo color_map { [0.2 rgb <0.012, 0.028, 0.005>] [0.8 rgb <0.06, 0.09, 0.012>] } scale 0.04]
      [0.9 bozo color_map { [0.2 rgb <0.022, 0.055, 0.007>] [0.5 rgb <0.085, 0.15, 0.016>]
        [0.8 rgb <0.23, 0.30, 0.04>] } scale 0.04]
    }
  }
  normal { bumps 0.9 scale 0.028 }
  finish { DustFinish }
}
// LeafSkin: texture. Waxy green, paler where light goes through.
#declare LeafSkin = texture {
  pigment {
    aoi
    pigment_map {
      [0.5 rgb <0.24, 0.38, 0.045>]
      [0.72 wrinkles color_map { [0.2 rgb <0.035, 0.12, 0.018>] [0.6 rgb <0.06, 0.18, 0.025>]
        [0.9 rgb <0.13, 0.26, 0.05>] } scale 0.3]
    }
  }
  normal { wrinkles 0.15 scale 0.2 }
  finish { GlossyFinish(0.6) }
}
// PetalSkin: texture. Silky rose, deeper towards the middle.
#declare PetalSkin = texture {
  pigment { RimPigment(rgb <0.62, 0.10, 0.22>, rgb <0.92, 0.46, 0.52>) }
  normal { bumps 0.03 scale <0.02, 0.2, 0.02> }
  finish { ambient 0.09 diffuse 0.79 brilliance 0.6 specular albedo 0.02 roughness 0.12 }
}
// MushroomCap: texture. Red with white flakes, as in tales; white below.
#declare MushroomCap = texture {
  slope y
  texture_map {
    [0.34 pigment { gradient x color_map { [0 rgb <0.62, 0.54, 0.42>]
      [1 rgb <0.78, 0.72, 0.60>] } sine_wave scale 0.05 } finish { FleshFinish }]
    [0.42
      pigment {
        crackle form <1, 0, 0>
        color_map { [0.2 rgb <0.82, 0.78, 0.66>] [0.28 rgb <0.74, 0.60, 0.45>] [0.3 rgb <0.56, 0.05, 0.012>]
          [0.8 rgb <0.64, 0.075, 0.015>] }
        warp { turbulence 0.12 octaves 3 }
        scale 0.3
      }
      normal { crackle -0.5 form <1, 0, 0> accuracy 0.01 slope_map { [0 <0, 0>] [0.24 <0.2, 0>] [0.3 <1, 0>]
        [1 <1, 0>] } scale 0.3 }
      finish { GlossyFinish(0.65) }
    ]
  }
}
// CactusSkin: texture. Grey green wax, with rows of pale cushions for spines.
#declare CactusSkin = texture {
  pigment {
    leopard
    color_map { [0.55 rgb <0.07, 0.17, 0.06>] [0.8 rgb <0.13, 0.23, 0.09>] [0.92 rgb <0.60, 0.52, 0.34>] }
    scale 0.045
  }
  normal { leopard 0.25 scale 0.045 }
  finish { GlossyFinish(0.4) }
}

// ---- Wax, bone, horn ------------------------------------------------------------------------------------------------

// CandleWax: texture. White wax, light in its thin parts.
#declare CandleWax = texture {
  pigment { RimPigment(rgb <0.80, 0.71, 0.54>, rgb <0.96, 0.84, 0.62>) }
  normal { bumps 0.06 scale 0.2 }
  finish { WaxFinish }
}
// BeesWax: texture. Honey yellow, with a dull bloom.
#declare BeesWax = texture {
  pigment { RimPigment(rgb <0.66, 0.35, 0.055>, rgb <0.90, 0.58, 0.14>) }
  normal { bumps 0.1 scale 0.12 }
  finish { WaxFinish }
}
// OldBone: texture. Ivory, brown in its pores and cracks.
#declare OldBone = texture {
  pigment {
    granite
    color_map { [0.1 rgb <0.74, 0.65, 0.48>] [0.5 rgb <0.66, 0.55, 0.37>] [0.66 rgb <0.46, 0.33, 0.18>]
      [0.8 rgb <0.22, 0.13, 0.06>] }
    scale <0.5, 1.1, 0.5>
  }
  normal { granite 0.22 accuracy 0.01 scale <0.25, 0.5, 0.25> }
  finish { ChalkFinish specular albedo 0.015 roughness 0.08 }
}
// BleachedBone: texture. From the desert: white, dry, with fine cracks.
#declare BleachedBone = texture {
  pigment {
    crackle
    color_map { [0.01 rgb <0.42, 0.36, 0.28>] [0.035 rgb <0.76, 0.72, 0.64>] [0.4 rgb <0.84, 0.81, 0.74>] }
    warp { turbulence 0.4 octaves 4 }
    scale <0.4, 0.9, 0.4>
  }
  normal { bumps 0.12 scale 0.03 }
  finish { ChalkFinish }
}
// Ivory: texture. Polished, with a faint grain.
#declare Ivory = texture {
  pigment {
    wood turbulence 0.06 octaves 2
    color_map { [0.2 rgb <0.80, 0.70, 0.50>] [0.9 rgb <0.72, 0.60, 0.40>] }
    scale 0.09 rotate 80*x
  }
  finish { WaxFinish diffuse 0.66 reflection { 0.02, 0.16 falloff 5 } specular albedo 0.04 roughness 0.012 }
}
// DarkHorn: texture. Layers of brown and black, half polished: horns, hooves, claws.
#declare DarkHorn = texture {
  pigment {
    gradient y turbulence 0.25 octaves 4 sine_wave
    color_map { [0.1 rgb <0.022, 0.015, 0.010>] [0.6 rgb <0.085, 0.05, 0.028>] [0.9 rgb <0.26, 0.17, 0.09>] }
    scale 0.6
  }
  normal { gradient y 0.2 turbulence 0.1 sine_wave accuracy 0.01 scale 0.07 }
  finish { GlossyFinish(0.7) }
}

// ---- Chitin ---------------------------------------------------------------------------------------------------------

// BeetleGreen: texture. Rose chafer: green gold.
#declare BeetleGreen = ChitinShell(rgb <0.06, 0.46, 0.10>, rgb <0.78, 0.46, 0.03>, 0.3)
// BeetleBlue: texture. Blue violet steel.
#declare BeetleBlue = ChitinShell(rgb <0.03, 0.12, 0.55>, rgb <0.50, 0.06, 0.55>, 0.35)
// BeetleBlack: texture. Stag beetle: black with a breath of brown.
#declare BeetleBlack = ChitinShell(rgb <0.012, 0.009, 0.008>, rgb <0.07, 0.03, 0.018>, 0)
// LadybirdRed: texture. Red lacquer with black spots.
#declare LadybirdRed = texture {
  pigment {
    crackle form <1, 0, 0>
    color_map { [0.27 rgb 0.006] [0.29 rgb <0.58, 0.03, 0.01>] [0.8 rgb <0.66, 0.05, 0.012>] }
    scale 0.52
  }
  finish { GlossyFinish(0.9) }
}
// CrabShell: texture. Red brown above, cream below, with small warts.
#declare CrabShell = texture {
  pigment {
    slope y
    pigment_map {
      [0.15 rgb <0.78, 0.56, 0.36>]
      [0.42 granite color_map { [0.2 rgb <0.62, 0.26, 0.10>] [0.7 rgb <0.48, 0.13, 0.045>] } scale 0.4]
      [0.8 granite color_map { [0.2 rgb <0.44, 0.085, 0.03>] [0.7 rgb <0.20, 0.045, 0.03>] } scale 0.4]
    }
  }
  normal { crackle -0.4 form <1, 0, 0> accuracy 0.01 slope_map { [0 <0, 0.5>] [0.35 <1, 0>] [1 <1, 0>] } scale 0.07 }
  finish { GlossyFinish(0.62) }
}

// ---- Animals --------------------------------------------------------------------------------------------------------

// FrogSkin: texture. Wet, green with dark spots, yellow below.
#declare FrogSkin = texture {
  pigment {
    slope y
    pigment_map {
      [0.22 rgb <0.62, 0.60, 0.28>]
      [0.5 bozo turbulence 0.25 octaves 3 color_map { [0.5 rgb <0.14, 0.34, 0.03>] [0.6 rgb <0.20, 0.40, 0.04>]
        [0.64 rgb <0.03, 0.055, 0.012>] [0.9 rgb <0.02, 0.035, 0.01>] } scale 0.22]
    }
  }
  normal { bumps 0.25 scale 0.05 }
  finish { GlossyFinish(0.92) }
}
// LizardSkin: texture. Green scales with dark skin between.
#declare LizardSkin = ScaleSkin(rgb <0.13, 0.30, 0.07>, rgb <0.02, 0.03, 0.012>, 0.1, 0.6)
// SnakeSkin: texture. Sand and brown scales in blotches.
#declare SnakeSkin = texture {
  pigment {
    bozo turbulence 0.15 octaves 2
    pigment_map {
      [0.46 crackle color_map { [0.03 rgb <0.12, 0.085, 0.04>] [0.2 rgb <0.50, 0.38, 0.20>]
        [0.7 rgb <0.62, 0.50, 0.30>] } scale 0.06/0.42]
      [0.52 crackle color_map { [0.03 rgb <0.012, 0.008, 0.005>] [0.2 rgb <0.10, 0.055, 0.025>]
        [0.7 rgb <0.15, 0.085, 0.04>] } scale 0.06/0.42]
    }
    scale 0.42
  }
  normal { crackle 0.6 accuracy 0.012 slope_map { [0 <0, 1>] [0.14 <0.7, 1>] [0.4 <1, 0>] [1 <1, 0>] } scale 0.06 }
  finish { GlossyFinish(0.55) }
}
// FishScales: texture. Silver with a dark blue back and a rainbow on the flanks.
#declare FishScales = texture {
  pigment {
    slope y
    pigment_map {
      [0.3 crackle color_map { [0.02 rgb <0.50, 0.52, 0.52>] [0.2 rgb <0.82, 0.82, 0.80>] } scale 0.1]
      [0.6 crackle color_map { [0.02 rgb <0.24, 0.32, 0.34>] [0.2 rgb <0.50, 0.60, 0.60>] } scale 0.1]
      [0.85 crackle color_map { [0.02 rgb <0.012, 0.04, 0.06>] [0.2 rgb <0.03, 0.09, 0.13>] } scale 0.1]
    }
  }
  normal { crackle 0.5 accuracy 0.012 slope_map { [0 <0, 1>] [0.14 <0.7, 1>] [0.4 <1, 0>] [1 <1, 0>] } scale 0.1 }
  finish { ambient 0.06 diffuse 0.5 specular albedo 0.3 roughness 0.03 metallic 0.5
    reflection { 0.1, 0.4 falloff 3 metallic 0.5 } irid { 0.18 thickness 0.6 } }
}
// OctopusSkin: texture. Wine red clouds on cream, wet, with small warts.
#declare OctopusSkin = texture {
  pigment {
    slope y
    pigment_map {
      [0.2 rgb <0.72, 0.50, 0.42>]
      [0.5 bozo turbulence 0.5 octaves 4 color_map { [0.25 rgb <0.62, 0.30, 0.22>] [0.5 rgb <0.42, 0.10, 0.085>]
        [0.75 rgb <0.19, 0.028, 0.04>] } scale 0.28]
    }
  }
  normal { average normal_map { [1 bumps 0.35 scale 0.04] [1 wrinkles 0.3 scale 0.25] } }
  finish { GlossyFinish(0.88) }
}
// ElephantHide: texture. Grey, folded, dusty.
#declare ElephantHide = texture {
  pigment {
    crackle
    color_map { [0 rgb <0.085, 0.075, 0.068>] [0.08 rgb <0.16, 0.145, 0.135>] [0.6 rgb <0.22, 0.20, 0.185>] }
    warp { turbulence 0.5 octaves 4 }
    scale 0.12
  }
  normal {
    average
    normal_map { [1 crackle 0.6 accuracy 0.015 slope_map { [0 <0, 2>] [0.15 <1, 0>]
      [1 <1, 0>] } turbulence 0.4 octaves 3 scale 0.12] [1.5 wrinkles 0.5 scale 0.5] }
  }
  finish { ChalkFinish }
}
// PaleSkin: texture. Human skin, fair.
#declare PaleSkin = HumanSkin(rgb <0.66, 0.39, 0.28>)
// TannedSkin: texture. Human skin, olive.
#declare TannedSkin = HumanSkin(rgb <0.38, 0.19, 0.105>)
// DarkSkin: texture. Human skin, deep brown.
#declare DarkSkin = HumanSkin(rgb <0.10, 0.046, 0.026>)
// VelvetFur: texture. A mole's coat: dark in the middle, light at the outline.
#declare VelvetFur = texture {
  pigment { RimPigment(rgb <0.035, 0.026, 0.022>, rgb <0.36, 0.30, 0.26>) }
  normal { bumps 0.12 scale <0.012, 0.05, 0.012> }
  finish { DustFinish }
}

// ---- Jelly ----------------------------------------------------------------------------------------------------------

// MoonJelly: material. Sea jelly: clear, milky at its rims, a touch of blue.
#declare MoonJelly = JellyFlesh(rgb <0.80, 0.91, 0.99>, 0.92)
// PinkJelly: material. Rose and clear.
#declare PinkJelly = JellyFlesh(rgb <0.96, 0.52, 0.62>, 0.88)
// GreenSlime: material. Thick, wet, poisonous.
#declare GreenSlime = JellyFlesh(rgb <0.50, 0.85, 0.08>, 0.78)

#version Skins_Isl_Before;
#end
