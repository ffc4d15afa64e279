// Papers, cloth, clays, plasters and ceramics: quiet surfaces that show form and light.
//
//   #include "papers.isl"
//   sphere { 0, 1 texture { WhitePaper } }
//   sphere { 0, 1 GlazedCeramic(rgb <0.05, 0.22, 0.30>, rgb <0.45, 0.62, 0.55>) }
//
// Made for things about 2 units large; scale the texture with them.
#ifndef (Papers_Isl_Before)
#declare Papers_Isl_Before = version;
#version 3.7;
#include "finishes.isl"

// ---- Macros ---------------------------------------------------------------------------------------------------------

// PaperTexture(Colour, Grain)
// Paper of any colour with its fibres.
// Grain: 0.05 smooth print, 0.2 drawing paper, 0.5 made by hand.
// Example: sphere { 0, 1 PaperTexture(rgb <0.75, 0.35, 0.25>, 0.2) }
#macro PaperTexture(Colour, Grain)
  texture {
    pigment { granite color_map { [0.2 color Colour] [0.8 color Colour*(1 - 0.25*Grain)] } scale 0.25 }
    normal { granite 0.35*Grain accuracy 0.006 scale 0.12 }
    finish { ambient 0.09 diffuse 0.86 brilliance 0.9 }
  }
#end

// ClayTexture(Colour, Wet)
// Modelling clay: soft dents of fingers.
// Wet: 0 dry, 0.5 leather hard, 1 fresh from the wheel.
// Example: sphere { 0, 1 ClayTexture(rgb <0.38, 0.20, 0.13>, 0.6) }
#macro ClayTexture(Colour, Wet)
  texture {
    pigment { bozo turbulence 0.4 octaves 3 color_map { [0.3 color Colour] [0.8 color Colour*0.88] } scale 0.5 }
    normal { average normal_map { [1 bumps 0.3 scale 0.3] [1 granite 0.16 accuracy 0.008 scale 0.2] } }
    finish { GlossyFinish(0.25 + 0.5*Wet) }
  }
#end

// GlazedCeramic(Glaze, Thin)
// A glaze that has run: thick and deep on what faces up and in the hollows, thin on what hangs over.
// Glaze: its colour where it is thick. Thin: where it is thin, or the clay that shows through.
// Example: sphere { 0, 1 GlazedCeramic(rgb <0.02, 0.12, 0.20>, rgb <0.45, 0.30, 0.16>) }
#macro GlazedCeramic(Glaze, Thin)
  texture {
    pigment {
      pigment_pattern {
        average
        pigment_map {
          [1.4 slope y color_map { [0 rgb 0] [1 rgb 1] }]
          [1 bozo turbulence 0.5 octaves 3 color_map { [0 rgb 0] [1 rgb 1] } scale <0.3, 0.6, 0.3>]
        }
      }
      color_map { [0.28 color Thin] [0.42 color 0.55*Thin + 0.45*Glaze] [0.58 color Glaze] [0.8 color Glaze*0.8] }
    }
    normal { bumps 0.06 scale 0.25 }
    finish { GlossyFinish(0.95) }
  }
#end

// FeltTexture(Colour)
// Felt, velvet, flock: light at its outline, as fibres there catch the light.
// Example: sphere { 0, 1 FeltTexture(rgb <0.45, 0.05, 0.08>) }
#macro FeltTexture(Colour)
  texture {
    pigment { aoi color_map { [0.5 color 0.55*Colour + <0.36, 0.36, 0.36, 0, 0>]
      [0.62 color 0.85*Colour + <0.08, 0.08, 0.08, 0, 0>] [0.8 color Colour*0.8] [1 color Colour*0.62] } }
    normal { bumps 0.16 scale 0.012 }
    finish { DustFinish }
  }
#end

// ---- Papers ---------------------------------------------------------------------------------------------------------

// WhitePaper: texture. Drawing paper.
#declare WhitePaper = PaperTexture(rgb <0.84, 0.835, 0.815>, 0.2)
// BlackCard: texture. Black cardboard.
#declare BlackCard = PaperTexture(rgb <0.022, 0.022, 0.024>, 0.25)
// KraftPaper: texture. Brown wrapping paper with fibres.
#declare KraftPaper = texture {
  pigment {
    granite
    color_map { [0.15 rgb <0.34, 0.20, 0.10>] [0.4 rgb <0.46, 0.29, 0.16>] [0.8 rgb <0.54, 0.36, 0.21>] }
    scale <0.5, 0.06, 0.5> rotate <20, 0, 30>
  }
  normal { granite 0.1 accuracy 0.006 scale <0.3, 0.04, 0.3> rotate <20, 0, 30> }
  finish { ambient 0.09 diffuse 0.85 brilliance 0.9 }
}
// PaperMache: texture. Strips of torn paper, glued one over another.
#declare PaperMache = texture {
  pigment {
    crackle solid
    color_map { [0 rgb <0.60, 0.575, 0.52>] [1 rgb <0.77, 0.745, 0.69>] }
    warp { turbulence 0.12 octaves 4 omega 0.6 }
    scale <0.3, 0.16, 0.3> rotate 25*z
  }
  normal {
    crackle 0.5 accuracy 0.01
    slope_map { [0 <0, 1>] [0.1 <0.7, 1>] [0.3 <1, 0>] [1 <1, 0>] }
    warp { turbulence 0.12 octaves 4 omega 0.6 }
    scale <0.3, 0.16, 0.3> rotate 25*z
  }
  finish { MatteFinish }
}
// Parchment: texture. Old skin to write on: cream, stained with brown.
#declare Parchment = texture {
  pigment {
    bozo turbulence 0.7 octaves 5 omega 0.6
    color_map { [0.25 rgb <0.70, 0.56, 0.34>] [0.55 rgb <0.62, 0.46, 0.25>] [0.75 rgb <0.48, 0.31, 0.14>]
      [0.92 rgb <0.28, 0.15, 0.06>] }
    scale 0.8
  }
  normal { wrinkles 0.2 scale 0.5 }
  finish { EggshellFinish }
}
// RicePaper: texture. Thin white paper of lanterns, with long fibres, light at its rims.
#declare RicePaper = texture {
  pigment {
    aoi
    pigment_map {
      [0.5 rgb <0.92, 0.88, 0.78>]
      [0.7 wrinkles turbulence 0.4 color_map { [0.3 rgb <0.82, 0.77, 0.66>] [0.5 rgb <0.76, 0.70, 0.58>]
        [0.75 rgb <0.86, 0.82, 0.74>] } scale 0.5]
    }
  }
  normal { wrinkles 0.25 scale 0.25 }
  finish { ambient 0.1 diffuse 0.79 brilliance 0.6 }
}

// ---- Cloth ----------------------------------------------------------------------------------------------------------

// RedFelt: texture. Thick wool felt.
#declare RedFelt = FeltTexture(rgb <0.42, 0.03, 0.035>)
// BlueVelvet: texture. Dark in the middle, bright at the folds.
#declare BlueVelvet = FeltTexture(rgb <0.012, 0.03, 0.20>)
// LinenCloth: texture. A coarse weave, natural colour.
#declare LinenCloth = texture {
  pigment {
    average
    pigment_map {
      [1 gradient x sine_wave color_map { [0 rgb <0.40, 0.34, 0.25>] [1 rgb <0.66, 0.58, 0.46>] }
        warp { turbulence 0.15 octaves 2 } scale 0.035]
      [1 gradient y sine_wave color_map { [0 rgb <0.40, 0.34, 0.25>] [1 rgb <0.66, 0.58, 0.46>] }
        warp { turbulence 0.15 octaves 2 } scale 0.035]
    }
  }
  normal {
    average
    normal_map { [1 gradient x 0.4 sine_wave accuracy 0.01 scale 0.035]
      [1 gradient y 0.4 sine_wave accuracy 0.01 scale 0.035] }
  }
  finish { MatteFinish }
}

// ---- Clay and plaster -----------------------------------------------------------------------------------------------

// WhitePlaster: texture. Casts and models: flat white.
#declare WhitePlaster = texture {
  pigment { bozo color_map { [0.3 rgb <0.80, 0.79, 0.765>] [0.7 rgb <0.84, 0.832, 0.81>] } scale 0.3 }
  normal { bumps 0.07 scale 0.03 }
  finish { ChalkFinish }
}
// RoughStucco: texture. Thrown on a wall: coarse, warm white.
#declare RoughStucco = texture {
  pigment { granite color_map { [0.2 rgb <0.62, 0.55, 0.45>] [0.7 rgb <0.76, 0.70, 0.60>] } scale 0.3 }
  normal { granite 0.8 accuracy 0.012 scale 0.3 }
  finish { MatteFinish }
}
// RawConcrete: texture. Grey, with stains and small holes.
#declare RawConcrete = texture {
  pigment {
    granite turbulence 0.3
    color_map { [0.08 rgb <0.08, 0.078, 0.074>] [0.16 rgb <0.24, 0.235, 0.225>] [0.5 rgb <0.31, 0.305, 0.29>]
      [0.85 rgb <0.40, 0.39, 0.37>] }
    scale 0.7
  }
  normal { granite 0.2 accuracy 0.008 scale 0.3 }
  finish { MatteFinish }
}
// TerraCotta: texture. Flower pots: orange brown, with a bloom of lime.
#declare TerraCotta = texture {
  pigment {
    bozo turbulence 0.5 octaves 4
    color_map { [0.25 rgb <0.50, 0.185, 0.085>] [0.6 rgb <0.56, 0.24, 0.12>] [0.9 rgb <0.64, 0.42, 0.30>] }
    scale 0.55
  }
  normal { gradient y 0.12 turbulence 0.05 sine_wave accuracy 0.01 scale 0.06 }
  finish { MatteFinish }
}
// GreyClay: texture. What sculptors model in.
#declare GreyClay = ClayTexture(rgb <0.27, 0.26, 0.24>, 0.3)
// RedClay: texture. Fresh from the wheel.
#declare RedClay = ClayTexture(rgb <0.34, 0.135, 0.07>, 0.8)

// ---- Ceramics -------------------------------------------------------------------------------------------------------

// WhitePorcelain: texture. White, a breath of blue, glazed.
#declare WhitePorcelain = texture {
  pigment { aoi color_map { [0.5 rgb <0.72, 0.77, 0.84>] [0.75 rgb <0.83, 0.84, 0.85>] } }
  finish { GlossyFinish(0.95) }
}
// BisquePorcelain: texture. Fired without a glaze: silky, half translucent, as dolls are.
#declare BisquePorcelain = texture {
  pigment { aoi color_map { [0.5 rgb <0.90, 0.80, 0.72>] [0.75 rgb <0.82, 0.77, 0.72>] } }
  finish { WaxFinish phong 0 specular albedo 0.03 roughness 0.12 }
}
// The net of fine cracks that an old glaze has, as a layer.
#macro Papers_Isl_Crazed(Glaze, Thin)
  GlazedCeramic(Glaze, Thin)
  texture {
    pigment {
      crackle
      color_map { [0.012 rgbt <0.10, 0.09, 0.05, 0.45>] [0.025 rgbt <0.1, 0.09, 0.05, 1>] }
      scale 0.16
    }
    finish { GlossyFinish(0.95) reflection 0 specular 0 }
  }
#end
// CeladonGlaze: texture. Grey green, with a net of fine cracks.
#declare CeladonGlaze = Papers_Isl_Crazed(rgb <0.22, 0.38, 0.29>, rgb <0.42, 0.50, 0.39>)
// TenmokuGlaze: texture. Black that breaks to rust where it is thin.
#declare TenmokuGlaze = GlazedCeramic(rgb <0.010, 0.008, 0.008>, rgb <0.30, 0.085, 0.02>)
// LagoonGlaze: texture. Turquoise over deep blue, running.
#declare LagoonGlaze = GlazedCeramic(rgb <0.008, 0.10, 0.19>, rgb <0.12, 0.50, 0.44>)
// OxbloodGlaze: texture. Deep red, pale where it has run thin.
#declare OxbloodGlaze = GlazedCeramic(rgb <0.24, 0.008, 0.010>, rgb <0.55, 0.36, 0.28>)

#version Papers_Isl_Before;
#end
