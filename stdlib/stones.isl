// Stones: marbles, granites, sediments, gems that are cut from the rock, and stones with something on them.
//
//   #include "stones.isl"
//   sphere { 0, 1 texture { CarraraMarble } }
//   blob { … texture { MossyRock scale 0.5 } }
//
// All are solid textures: they go through the body as veins go through a rock, so a blend of balls looks carved of one
// piece. They are made for objects about 2 units large; scale the texture with the object. What grows or lies on a
// stone is above, y.
#ifndef (Stones_Isl_Before)
#declare Stones_Isl_Before = version;
#version 3.7;
#include "finishes.isl"

// ---- Macros ---------------------------------------------------------------------------------------------------------

// VeinedMarble(Ground, Vein, Turbulence)
// Polished marble: clouded ground, thin dark veins that split and fade.
// Ground, Vein: colours. Turbulence: 0.5 calm bands … 1.2 torn.
// Example: sphere { 0, 1 VeinedMarble(rgb <0.85, 0.82, 0.78>, rgb <0.25, 0.22, 0.22>, 0.9) }
#macro VeinedMarble(Ground, Vein, Turbulence)
  #local Ground_ = <0, 0, 0> + Ground;
  #local Vein_ = <0, 0, 0> + Vein;
  #local Rgb_ = <Vein_.red, Vein_.green, Vein_.blue>;
  texture {
    pigment {
      bozo turbulence 0.6 octaves 4
      color_map { [0.25 rgb <Ground_.red, Ground_.green, Ground_.blue>]
        [0.8 rgb 0.8*<Ground_.red, Ground_.green, Ground_.blue> + 0.2*Rgb_] }
      scale 0.7
    }
    finish { GlazedFinish }
  }
  texture {
    pigment {
      marble turbulence Turbulence octaves 5 omega 0.62
      color_map {
        [0.3 rgbt <Rgb_.x, Rgb_.y, Rgb_.z, 1>] [0.7 rgbt <Rgb_.x, Rgb_.y, Rgb_.z, 0.82>]
        [0.9 rgbt <Rgb_.x, Rgb_.y, Rgb_.z, 0.6>] [0.955 rgbt <Rgb_.x, Rgb_.y, Rgb_.z, 0.25>]
        [1 rgbt <Rgb_.x, Rgb_.y, Rgb_.z, 0.1>]
      }
      scale 0.62 rotate <25, 40, 65>
    }
    finish { GlazedFinish reflection 0 specular 0 }
  }
#end

// CoveredAbove(Base, Cover, Amount)
// A texture with another one on what faces up, ragged at the border: moss, snow, sand, dust.
// Base, Cover: textures of one layer each. Amount: 0 none, 0.5 what faces up, 0.8 nearly all.
// Example: sphere { 0, 1 CoveredAbove(Basalt, texture { pigment { rgb 0.9 } }, 0.5) }
#macro CoveredAbove(Base, Cover, Amount)
  texture {
    pigment_pattern {
      average
      pigment_map {
        [2 slope y color_map { [0 rgb 0] [1 rgb 1] }]
        [0.6 granite color_map { [0.1 rgb 0] [0.6 rgb 1] } scale 0.6]
      }
    }
    texture_map { [0.96*(1 - Amount) Base] [0.96*(1 - Amount) + 0.05 Cover] }
  }
#end

// SpeckledStone(First, Second, Third, Size)
// Grains of three colours: granite and its kin.
// Size: of a grain, in units; 0.05 fine, 0.12 coarse.
// Example: sphere { 0, 1 SpeckledStone(rgb 0.05, rgb 0.5, rgb <0.6, 0.35, 0.3>, 0.08) }
#macro SpeckledStone(First, Second, Third, Size)
  texture {
    pigment {
      crackle solid
      color_map {
        [0.36 color First] [0.36 color Second*0.8] [0.47 color Second] [0.55 color Second*1.1] [0.55 color Third*0.8]
        [0.66 color Third] [0.66 color First*0.4 + Second*0.6] [0.8 color Third]
      }
      warp { turbulence 0.5*Size octaves 3 lambda 2.5 }
      scale Size
    }
    finish { GlazedFinish }
  }
#end

// BandedStone(Ramp, Width, Turbulence)
// Layers one upon another, as in agate, onyx and malachite.
// Ramp: a color_map, which the bands repeat. Width: of a band, in units. Turbulence: 0.2 calm … 0.8.
// Example: sphere { 0, 1 BandedStone(color_map { [0 rgb <0.4, 0.1, 0.02>] [1 rgb <0.9, 0.7, 0.5>] }, 0.3, 0.4) }
#macro BandedStone(Ramp, Width, Turbulence)
  texture {
    pigment {
      onion sine_wave
      color_map { Ramp }
      warp { turbulence Turbulence octaves 3 omega 0.4 lambda 2.3 }
      scale Width
      translate <0.4, -0.5, 0.7>
    }
    finish { GlazedFinish }
  }
#end

// ---- Marble, polished -----------------------------------------------------------------------------------------------

// CarraraMarble: texture. White, with thin grey veins: statues.
#declare CarraraMarble = VeinedMarble(rgb <0.82, 0.81, 0.79>, rgb <0.30, 0.31, 0.34>, 0.9)
// NeroMarble: texture. Black with white and golden lightning.
#declare NeroMarble =
  texture {
    pigment { bozo turbulence 0.5 octaves 3 color_map { [0.2 rgb 0.012] [0.8 rgb <0.035, 0.032, 0.03>] } scale 0.6 }
    finish { GlazedFinish }
  }
  texture {
    pigment {
      marble turbulence 1 octaves 6 omega 0.6
      color_map { [0.9 rgbt <0.5, 0.4, 0.25, 1>] [0.965 rgbt <0.62, 0.50, 0.32, 0.5>] [0.99 rgb <0.8, 0.75, 0.66>] }
      scale 0.75 rotate <15, 30, 55>
    }
    finish { GlazedFinish reflection 0 specular 0 }
  }
// VerdeMarble: texture. Dark green with pale veins.
#declare VerdeMarble = VeinedMarble(rgb <0.05, 0.13, 0.085>, rgb <0.38, 0.50, 0.40>, 1.1)
// RossoMarble: texture. Red brown with white clouds and veins.
#declare RossoMarble = VeinedMarble(rgb <0.34, 0.09, 0.055>, rgb <0.75, 0.60, 0.52>, 1)
// SienaMarble: texture. Warm yellow with violet veins.
#declare SienaMarble = VeinedMarble(rgb <0.72, 0.47, 0.18>, rgb <0.28, 0.12, 0.12>, 0.8)
// OnyxStone: texture. Layers of honey and cream, half clear.
#declare OnyxStone = BandedStone(color_map {
  [0 rgb <0.52, 0.26, 0.07>] [0.3 rgb <0.78, 0.55, 0.26>] [0.55 rgb <0.88, 0.76, 0.52>] [0.75 rgb <0.70, 0.44, 0.18>]
    [1 rgb <0.90, 0.84, 0.70>]
}, 0.55, 0.5)

// ---- Granite and its kin --------------------------------------------------------------------------------------------

// GreyGranite: texture. Polished, grey with black mica.
#declare GreyGranite = SpeckledStone(rgb <0.035, 0.035, 0.04>, rgb <0.36, 0.36, 0.36>, rgb <0.58, 0.57, 0.55>, 0.055)
// PinkGranite: texture. Polished, rose feldspar.
#declare PinkGranite = SpeckledStone(rgb <0.05, 0.045, 0.045>, rgb <0.52, 0.29, 0.22>, rgb <0.56, 0.46, 0.40>, 0.065)
// BlackGranite: texture. Polished, black with few glints.
#declare BlackGranite = SpeckledStone(rgb 0.008, rgb <0.018, 0.019, 0.021>, rgb <0.05, 0.052, 0.055>, 0.04)
// Terrazzo: texture. Chips of marble in cement, ground flat.
#declare Terrazzo =
  texture {
    pigment {
      crackle solid
      color_map {
        [0.25 rgb <0.74, 0.70, 0.64>] [0.25 rgb <0.40, 0.16, 0.11>] [0.4 rgb <0.46, 0.20, 0.13>]
          [0.4 rgb <0.10, 0.16, 0.15>]
        [0.55 rgb <0.13, 0.20, 0.18>] [0.55 rgb <0.62, 0.42, 0.20>] [0.7 rgb <0.66, 0.46, 0.24>]
          [0.7 rgb <0.80, 0.78, 0.74>] }
      scale 0.16
    }
    finish { GlazedFinish }
  }
  texture {
    pigment {
      crackle
      color_map { [0.13 rgb <0.55, 0.52, 0.47>] [0.16 rgbt <0.55, 0.52, 0.47, 1>] }
      scale 0.16
    }
    finish { GlazedFinish reflection 0 specular 0 }
  }

// ---- Rough rock -----------------------------------------------------------------------------------------------------

// Basalt: texture. Dark, rough, from a volcano.
#declare Basalt = texture {
  pigment { granite color_map { [0 rgb 0.018] [0.5 rgb <0.05, 0.049, 0.052>]
    [0.9 rgb <0.10, 0.097, 0.095>] } scale 0.5 }
  normal { granite 0.5 accuracy 0.01 scale 0.4 }
  finish { ChalkFinish }
}
// PorousLava: texture. Cooled foam: dark red brown, full of holes.
#declare PorousLava = texture {
  pigment {
    crackle form <1, 0, 0>
    color_map { [0.1 rgb 0.006] [0.3 rgb <0.05, 0.028, 0.022>] [0.8 rgb <0.12, 0.058, 0.04>] }
    warp { turbulence 0.15 octaves 2 }
    scale 0.12
  }
  normal { crackle 0.9 form <1, 0, 0> accuracy 0.02 slope_map { [0 <0, 0>] [0.15 <0.1, 1>] [0.5 <1, 0.5>]
    [1 <1, 0>] } scale 0.12 }
  finish { ChalkFinish }
}
// Sandstone: texture. Layers of warm sand, gritty.
#declare Sandstone = texture {
  pigment {
    gradient y turbulence <0.12, 0.12, 0.12> octaves 4
    color_map {
      [0 rgb <0.54, 0.33, 0.19>] [0.15 rgb <0.62, 0.43, 0.26>] [0.4 rgb <0.48, 0.26, 0.14>]
        [0.55 rgb <0.66, 0.48, 0.31>]
      [0.8 rgb <0.57, 0.36, 0.21>] [1 rgb <0.54, 0.33, 0.19>] }
    scale 0.34 rotate <6, 0, 9>
  }
  normal { granite 0.28 accuracy 0.006 scale 0.12 }
  finish { ChalkFinish }
}
// Limestone: texture. Pale, even, with the ghosts of shells.
#declare Limestone = texture {
  pigment {
    dents turbulence 0.2
    color_map { [0 rgb <0.66, 0.62, 0.53>] [0.3 rgb <0.62, 0.57, 0.47>] [0.6 rgb <0.52, 0.47, 0.38>] }
    scale 0.2
  }
  normal { granite 0.12 accuracy 0.008 scale 0.15 }
  finish { ChalkFinish }
}
// Slate: texture. Dark blue grey, split in thin leaves.
#declare Slate = texture {
  pigment { granite color_map { [0.1 rgb <0.045, 0.052, 0.062>] [0.7 rgb <0.105, 0.115, 0.13>] } scale <1, 0.15, 1> }
  normal { gradient y 0.5 turbulence 0.25 octaves 4 accuracy 0.01 slope_map { [0 <0, 0.5>] [0.8 <1, 0.2>]
    [1 <0, -3>] } scale 0.16 rotate 12*z }
  finish { EggshellFinish }
}
// RiverPebble: texture. Smooth and wet, grey with a white band of quartz.
#declare RiverPebble =
  texture {
    pigment { granite color_map { [0.1 rgb <0.065, 0.07, 0.075>] [0.7 rgb <0.15, 0.155, 0.155>] } scale 0.35 }
    finish { GlossyFinish(0.9) }
  }
  texture {
    pigment {
      gradient <0.6, 1, 0.2> turbulence 0.12 octaves 4
      color_map { [0.06 rgbt 1] [0.08 rgbt <0.7, 0.68, 0.64, 0.15>] [0.13 rgbt <0.76, 0.74, 0.70, 0.1>] [0.15 rgbt 1] }
      scale 1.1 translate 0.25*y
    }
    finish { GlossyFinish(0.9) reflection 0 specular 0 }
  }
// ChalkCliff: texture. Soft white, with a few flints.
#declare ChalkCliff = texture {
  pigment {
    bozo turbulence 0.35 octaves 4
    color_map { [0.3 rgb <0.80, 0.79, 0.75>] [0.78 rgb <0.72, 0.70, 0.65>] [0.84 rgb <0.20, 0.19, 0.18>]
      [1 rgb <0.06, 0.06, 0.065>] }
    scale 0.3
  }
  normal { wrinkles 0.4 scale 0.2 }
  finish { ChalkFinish }
}
// Travertine: texture. Cream limestone from hot springs, in layers with rows of small holes.
#declare Travertine = texture {
  pigment {
    granite
    color_map { [0.2 rgb <0.72, 0.60, 0.44>] [0.55 rgb <0.60, 0.45, 0.29>] [0.66 rgb <0.50, 0.35, 0.21>]
      [0.74 rgb <0.13, 0.08, 0.05>] }
    scale <1.3, 0.22, 1.3>
  }
  finish { GlossyFinish(0.45) }
}

// ---- Stones for cutting ---------------------------------------------------------------------------------------------

// GreenJade: texture. Milky green that seems to hold light.
#declare GreenJade = texture {
  pigment {
    bozo turbulence 0.7 octaves 5
    color_map { [0.2 rgb <0.12, 0.34, 0.17>] [0.5 rgb <0.22, 0.45, 0.24>] [0.75 rgb <0.42, 0.60, 0.40>]
      [0.95 rgb <0.62, 0.74, 0.58>] }
    scale 0.55
  }
  finish { WaxFinish diffuse 0.64 reflection { 0.03, 0.18 falloff 5 } specular albedo 0.04 roughness 0.01 }
}
// LapisStone: texture. Deep blue with gold dust and white clouds.
#declare LapisStone =
  texture {
    pigment {
      granite turbulence 0.2
      color_map { [0.1 rgb <0.008, 0.016, 0.12>] [0.45 rgb <0.018, 0.045, 0.28>] [0.62 rgb <0.05, 0.10, 0.38>]
        [0.8 rgb <0.42, 0.46, 0.55>] }
      scale 0.8
    }
    finish { GlazedFinish }
  }
  texture {
    pigment {
      crackle solid
      color_map { [0.95 rgbt 1] [0.95 rgb <0.85, 0.60, 0.20>] }
      warp { turbulence 0.03 octaves 2 }
      scale 0.05
    }
    finish { ambient 0.08 diffuse 0.8 }
  }
// MalachiteStone: texture. Bands of green, from mint to nearly black.
#declare MalachiteStone = BandedStone(color_map {
  [0 rgb <0.005, 0.05, 0.03>] [0.2 rgb <0.01, 0.16, 0.085>] [0.45 rgb <0.03, 0.30, 0.16>] [0.6 rgb <0.01, 0.13, 0.07>]
  [0.8 rgb <0.16, 0.50, 0.32>] [1 rgb <0.02, 0.20, 0.11>]
}, 0.24, 0.65)
// BandedAgate: texture. Thin rings of red brown, grey and white.
#declare BandedAgate = BandedStone(color_map {
  [0 rgb <0.22, 0.06, 0.025>] [0.18 rgb <0.48, 0.17, 0.06>] [0.3 rgb <0.75, 0.62, 0.52>] [0.42 rgb <0.42, 0.28, 0.24>]
    [0.55 rgb <0.80, 0.76, 0.72>]
  [0.7 rgb <0.50, 0.33, 0.27>] [0.85 rgb <0.34, 0.10, 0.045>] [1 rgb <0.82, 0.72, 0.62>]
}, 0.34, 0.45)
// TurquoiseStone: texture. Sky blue with a web of brown.
#declare TurquoiseStone = texture {
  pigment {
    crackle
    color_map { [0.02 rgb <0.09, 0.05, 0.025>] [0.06 rgb <0.20, 0.30, 0.26>] [0.12 rgb <0.09, 0.50, 0.50>]
      [0.6 rgb <0.16, 0.60, 0.60>] }
    warp { turbulence 0.35 octaves 4 omega 0.55 }
    scale 0.34
  }
  finish { GlazedFinish }
}
// Obsidian: texture. Black glass of volcanoes.
#declare Obsidian = texture {
  pigment { bozo turbulence 0.4 color_map { [0.3 rgb 0.006] [0.9 rgb <0.02, 0.018, 0.016>] } scale <1, 0.2, 1> }
  finish { GlossyFinish(1) }
}
// RoseQuartz: texture. Pale rose, clouded.
#declare RoseQuartz = texture {
  pigment {
    granite turbulence 0.3
    color_map { [0.2 rgb <0.74, 0.42, 0.44>] [0.5 rgb <0.82, 0.56, 0.56>] [0.75 rgb <0.90, 0.76, 0.74>] }
    scale 1.3
  }
  finish { WaxFinish diffuse 0.64 reflection { 0.03, 0.18 falloff 5 } specular albedo 0.04 roughness 0.008 }
}

// ---- Stones with something on them ----------------------------------------------------------------------------------

// FieldRock: texture. An ordinary boulder: grey, with brown in its cracks.
#declare FieldRock = texture {
  pigment {
    granite
    color_map { [0.1 rgb <0.085, 0.07, 0.055>] [0.4 rgb <0.20, 0.185, 0.165>] [0.65 rgb <0.31, 0.30, 0.28>]
      [0.85 rgb <0.42, 0.41, 0.38>] }
    scale 0.9
  }
  normal { granite 0.6 accuracy 0.012 scale 0.7 }
  finish { ChalkFinish }
}
// MossyRock: texture. A boulder with moss on what faces up.
#declare MossyRock = CoveredAbove(FieldRock, texture {
  pigment { bozo color_map { [0.2 rgb <0.018, 0.045, 0.006>] [0.5 rgb <0.07, 0.125, 0.014>]
    [0.8 rgb <0.19, 0.25, 0.035>] } scale 0.05 }
  normal { bumps 0.9 scale 0.03 }
  finish { DustFinish }
}, 0.46)
// SnowyRock: texture. A boulder after the first snow.
#declare SnowyRock = CoveredAbove(FieldRock, texture {
  pigment { rgb <0.86, 0.89, 0.93> }
  normal { bumps 0.2 scale 0.15 }
  finish { ambient 0.09 diffuse 0.79 brilliance 0.6 }
}, 0.4)
// LichenRock: texture. A boulder with rosettes of lichen, grey green and yellow.
#declare LichenRock =
  texture { FieldRock }
  texture {
    pigment {
      bozo
      color_map { [0.26 rgb <0.36, 0.40, 0.29>] [0.335 rgb <0.47, 0.50, 0.38>] [0.36 rgbt <0.42, 0.46, 0.35, 1>] }
      warp { turbulence 0.25 octaves 5 omega 0.6 }
      scale 0.16
    }
    finish { MatteFinish }
  }
  texture {
    pigment {
      bozo
      color_map { [0.22 rgb <0.58, 0.33, 0.03>] [0.29 rgb <0.66, 0.46, 0.06>] [0.31 rgbt <0.6, 0.4, 0.05, 1>] }
      warp { turbulence 0.25 octaves 5 omega 0.6 }
      scale 0.14 translate <3, 5, 2>
    }
    finish { MatteFinish }
  }
// WetSand: texture. The beach after the wave: dark, fine, shining.
#declare WetSand = texture {
  pigment { granite color_map { [0.2 rgb <0.17, 0.115, 0.07>] [0.6 rgb <0.24, 0.17, 0.11>]
    [0.9 rgb <0.34, 0.26, 0.18>] } scale 0.05 }
  normal { bumps 0.12 scale 0.02 }
  finish { GlossyFinish(0.85) }
}
// DrySand: texture. A dune: pale, matt, with ripples of wind along x.
#declare DrySand = texture {
  pigment { granite color_map { [0.2 rgb <0.52, 0.38, 0.23>] [0.7 rgb <0.68, 0.53, 0.35>] } scale 0.04 }
  normal {
    average
    normal_map {
      [1 gradient z 0.5 turbulence 0.12 octaves 2 slope_map { [0 <0, 0.3>] [0.7 <1, 0.4>] [1 <0, -1>] } scale 0.2]
      [0.5 granite 0.2 accuracy 0.01 scale 0.05]
    }
  }
  finish { ChalkFinish }
}

#version Stones_Isl_Before;
#end
