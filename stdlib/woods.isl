// Woods and barks: solid textures, so that a blend of balls looks turned or carved of one piece.
//
//   #include "woods.isl"
//   sphere { 0, 1 texture { WalnutWood } }
//   blob { … texture { OakWood rotate 90*x scale 0.5 } }
//
// The trunk goes along y, leaning a little, with its heart before the thing: so its front shows the long ovals of a
// board, as bowls and figures do. Were the heart in the middle of a ball, the rings would be those of a beehive.
// Rotate or translate the texture to cut it otherwise. Made for things about 2 units large, as if of a thin trunk;
// scale the texture with them. Finishes are of oiled wood; VarnishedWood makes any of them shine.
#ifndef (Woods_Isl_Before)
#declare Woods_Isl_Before = version;
#version 3.7;
#include "finishes.isl"

// ---- Macros ---------------------------------------------------------------------------------------------------------

// WoodTexture(Early, Late, Ring, Wave, Gloss)
// Any wood: rings, rays of pores along the trunk, slow changes of colour.
// Early, Late: colours of the light and the dark part of a ring. Ring: its width in units, 0.05 slow to 0.2 fast
// growth.
// Wave: how uneven the rings are, 0.05 spruce … 0.3 olive. Gloss: as in GlossyFinish.
// Example: sphere { 0, 1 WoodTexture(rgb <0.62, 0.38, 0.18>, rgb <0.34, 0.16, 0.06>, 0.1, 0.1, 0.4) }
#macro WoodTexture(Early, Late, Ring, Wave, Gloss)
  texture { Woods_Isl_Rings(Early, Late, Ring, Wave) finish { GlossyFinish(Gloss) } }
  Woods_Isl_Pores(Late, 1)
#end

// The pigment and the bumps of rings.
#macro Woods_Isl_Rings(Early, Late, Ring, Wave)
  pigment {
    wood ramp_wave
    color_map {
      // Spring wood grows slowly darker; summer wood ends it sharply.
      [0 color Early]
      [0.35 color 0.9*Early + 0.1*Late]
      [0.75 color 0.45*Early + 0.55*Late]
      [0.9 color Late]
      [1 color Early]
    }
    warp { turbulence Wave*<1, 1, 0.12> octaves 3 omega 0.45 }
    scale <Ring, Ring, 1.3*Ring>
    // The rings are not quite round, and the trunk is not quite straight.
    scale <1, 0.86, 6>
    rotate <82, 0, 7>
    translate <0.2, 0, -1.2>
  }
#end

// A layer of pores: short dark strokes along the trunk. Amount: 0 none … 1 oak.
#macro Woods_Isl_Pores(Dark, Amount)
  #local Dark_ = <0, 0, 0> + Dark;
  #local C_ = 0.5*<Dark_.red, Dark_.green, Dark_.blue>;
  texture {
    pigment {
      bumps
      color_map { [0.30 rgbt <C_.x, C_.y, C_.z, 1 - 0.75*Amount>] [0.42 rgbt <C_.x, C_.y, C_.z, 1>] }
      scale <0.014, 0.014, 0.32>
      rotate <82, 0, 7>
    }
    finish { MatteFinish }
  }
#end

// VarnishedWood(Early, Late, Ring, Wave)
// The same under clear lacquer, which makes it deeper and shine.
// Early, Late, Ring, Wave: as in WoodTexture.
// Example: sphere { 0, 1 VarnishedWood(rgb <0.62, 0.30, 0.10>, rgb <0.30, 0.09, 0.02>, 0.1, 0.1) }
#macro VarnishedWood(Early, Late, Ring, Wave)
  texture { Woods_Isl_Rings(Early, Late, Ring, Wave) finish { WetFinish } }
  Woods_Isl_Pores(Late, 0.6)
#end

// BarkTexture(Ridge, Crack, Width)
// The bark of a standing trunk: plates along y with deep cracks between.
// Ridge, Crack: colours. Width: of a plate in units; 0.12 on a trunk 1 unit wide.
// Example: cylinder { -1.5*y, 1.5*y, 0.5 BarkTexture(rgb <0.30, 0.24, 0.19>, rgb <0.04, 0.03, 0.02>, 0.12) }
#macro BarkTexture(Ridge, Crack, Width)
  texture {
    pigment {
      crackle
      color_map { [0.0 color Crack] [0.1 color 0.5*Crack + 0.5*Ridge] [0.26 color Ridge] [0.9 color 1.35*Ridge] }
      warp { turbulence <0.5, 0.25, 0.5> octaves 4 omega 0.6 }
      scale <Width, 3.5*Width, Width>
    }
    normal {
      crackle 1.1 accuracy 0.015
      slope_map { [0 <0, 0>] [0.06 <0.1, 2>] [0.3 <0.9, 0.6>] [1 <1, 0>] }
      warp { turbulence <0.5, 0.25, 0.5> octaves 4 omega 0.6 }
      scale <Width, 3.5*Width, Width>
    }
    finish { ChalkFinish }
  }
#end

// ---- Woods ----------------------------------------------------------------------------------------------------------

// OakWood: texture. Honey brown, with strong pores.
#declare OakWood = WoodTexture(rgb <0.52, 0.31, 0.13>, rgb <0.30, 0.145, 0.05>, 0.10, 0.10, 0.4)
// WalnutWood: texture. Dark chocolate with violet, wavy.
#declare WalnutWood = WoodTexture(rgb <0.20, 0.095, 0.045>, rgb <0.06, 0.024, 0.013>, 0.14, 0.26, 0.5)
// CherryTimber: texture. Red brown, fine, even.
#declare CherryTimber = WoodTexture(rgb <0.48, 0.185, 0.07>, rgb <0.31, 0.09, 0.03>, 0.09, 0.12, 0.5)
// PineTimber: texture. Pale yellow with orange rings.
#declare PineTimber = WoodTexture(rgb <0.76, 0.53, 0.26>, rgb <0.52, 0.25, 0.075>, 0.13, 0.07, 0.35)
// BirchTimber: texture. Nearly white, silky, with faint rings.
#declare BirchTimber = WoodTexture(rgb <0.76, 0.62, 0.42>, rgb <0.62, 0.45, 0.27>, 0.12, 0.2, 0.45)
// TeakWood: texture. Golden brown with dark stripes, oily.
#declare TeakWood = WoodTexture(rgb <0.40, 0.20, 0.07>, rgb <0.16, 0.065, 0.02>, 0.16, 0.2, 0.55)
// MahoganyWood: texture. Deep red, under varnish.
#declare MahoganyWood = VarnishedWood(rgb <0.30, 0.065, 0.025>, rgb <0.12, 0.02, 0.01>, 0.1, 0.12)
// EbonyWood: texture. Black with brown streaks, polished.
#declare EbonyWood = VarnishedWood(rgb <0.022, 0.014, 0.011>, rgb <0.006, 0.005, 0.005>, 0.12, 0.15)
// OliveWood: texture. Yellow with wild dark lines: bowls and spoons.
#declare OliveWood = WoodTexture(rgb <0.62, 0.40, 0.14>, rgb <0.14, 0.06, 0.02>, 0.22, 0.5, 0.55)
// YewWood: texture. Orange heart and cream sapwood, in two sharp zones.
#declare YewWood = texture {
  pigment {
    cylindrical
    pigment_map {
      [0.44 wood color_map { [0 rgb <0.76, 0.58, 0.32>] [0.9 rgb <0.66, 0.46, 0.22>] }
        warp { turbulence 0.08 octaves 2 } scale 0.06]
      [0.47 wood color_map { [0 rgb <0.52, 0.19, 0.055>] [0.9 rgb <0.34, 0.10, 0.03>] }
        warp { turbulence 0.08 octaves 2 } scale 0.06]
    }
    warp { turbulence <0.18, 0.18, 0.05> octaves 3 }
    scale <1.7, 8, 1.7> rotate <-8, 0, 7>
    translate <0.3, 0, -1>
  }
  finish { GlossyFinish(0.55) }
}
// DriftWood: texture. Grey and dry from sun and sea, with deep grain.
#declare DriftWood = texture {
  pigment {
    granite
    color_map { [0.15 rgb <0.10, 0.088, 0.075>] [0.4 rgb <0.27, 0.25, 0.22>] [0.7 rgb <0.46, 0.44, 0.40>] }
    scale <0.3, 2.4, 0.3> rotate <0, 0, 24>
  }
  normal { granite 0.3 accuracy 0.01 scale <0.3, 2.4, 0.3> rotate <0, 0, 24> }
  finish { ChalkFinish }
}
// CharredWood: texture. Burnt: black, cracked into small blocks, with a dull sheen.
#declare CharredWood = texture {
  pigment {
    crackle
    color_map { [0.03 rgb 0.002] [0.2 rgb <0.012, 0.012, 0.013>] [0.7 rgb <0.03, 0.03, 0.032>] }
    scale <0.14, 0.2, 0.14>
  }
  normal { crackle 1 accuracy 0.012 slope_map { [0 <0, 0>] [0.08 <0.1, 2>] [0.25 <1, 0>]
    [1 <1, 0>] } scale <0.14, 0.2, 0.14> }
  finish { GlossyFinish(0.42) }
}
// BambooCane: texture. Yellow green with rings of nodes across y, polished by nature.
#declare BambooCane = texture {
  pigment {
    gradient y
    pigment_map {
      [0.0 rgb <0.20, 0.15, 0.05>]
      [0.03 rgb <0.62, 0.56, 0.30>]
      [0.08 bozo color_map { [0.3 rgb <0.42, 0.42, 0.09>] [0.7 rgb <0.58, 0.50, 0.16>] } scale <0.02, 0.5, 0.02>]
      [0.97 bozo color_map { [0.3 rgb <0.46, 0.46, 0.12>] [0.7 rgb <0.60, 0.54, 0.20>] } scale <0.02, 0.5, 0.02>]
      [1 rgb <0.20, 0.15, 0.05>]
    }
    scale 0.55
  }
  normal { gradient y 0.5 accuracy 0.01 slope_map { [0 <0, 0>] [0.03 <1, 0>] [0.07 <0.3, -1>] [0.2 <0, 0>]
    [1 <0, 0>] } scale 0.55 }
  finish { GlossyFinish(0.65) }
}

// ---- Barks ----------------------------------------------------------------------------------------------------------

// OakBark: texture. Deep furrows, grey brown.
#declare OakBark = BarkTexture(rgb <0.21, 0.165, 0.125>, rgb <0.022, 0.016, 0.012>, 0.14)
// PineBark: texture. Red plates.
#declare PineBark = BarkTexture(rgb <0.36, 0.16, 0.075>, rgb <0.04, 0.018, 0.012>, 0.2)
// BirchBark: texture. White paper with black lines across.
#declare BirchBark =
  texture {
    pigment { granite color_map { [0.2 rgb <0.80, 0.78, 0.73>] [0.65 rgb <0.70, 0.66, 0.60>]
      [0.85 rgb <0.52, 0.40, 0.30>] } scale <0.9, 0.3, 0.9> }
    normal { bumps 0.05 scale <0.4, 0.03, 0.4> }
    finish { GlossyFinish(0.3) }
  }
  texture {
    pigment {
      bozo turbulence <0.12, 0.05, 0.12> octaves 3
      color_map { [0.24 rgbt <0.03, 0.025, 0.022, 0>] [0.29 rgbt <0.10, 0.08, 0.065, 0.4>]
        [0.33 rgbt <0.1, 0.08, 0.07, 1>] }
      scale <0.3, 0.05, 0.3>
    }
    finish { MatteFinish }
  }
// CorkBark: texture. Light brown, full of dark pores.
#declare CorkBark = texture {
  pigment {
    granite
    color_map { [0.15 rgb <0.12, 0.055, 0.02>] [0.3 rgb <0.42, 0.24, 0.11>] [0.6 rgb <0.56, 0.36, 0.19>]
      [0.85 rgb <0.62, 0.43, 0.25>] }
    scale 0.22
  }
  normal { granite 0.3 accuracy 0.01 scale 0.22 }
  finish { MatteFinish }
}

#version Woods_Isl_Before;
#end
