// Finishes: how surfaces answer light, without their colour.
//
//   #include "finishes.isl"
//   sphere { 0, 1 pigment { rgb <0.8, 0.3, 0.2> } finish { SatinFinish } }
//   sphere { 0, 1 pigment { rgb <0.8, 0.3, 0.2> } finish { GlossyFinish(0.7) } }
//
// All keep to one rule: what is scattered (`diffuse`) and the most that is mirrored (at grazing angles) are together
// at most all light. Highlights are given by `albedo`: the number is the share of light that they hold, whatever their
// size. Mirrors grow with the fifth power of the angle, as Schlick's approximation of Fresnel's law has it ("An
// Inexpensive BRDF Model for Physically-Based Rendering", 1994), so that no interior is needed and a component of a
// blob may have them. `ambient` is low: it fills shadows a little in scenes with lamps alone, and `sky_light` takes
// its place.
#ifndef (Finishes_Isl_Before)
#declare Finishes_Isl_Before = version;
#version 3.7;

// ---- By one number --------------------------------------------------------------------------------------------------

// GlossyFinish(Gloss)
// Anything that is no metal, from chalk to lacquer. Below 0.5 nothing is mirrored, and no rays are spent on it.
// Gloss: 0 chalk, 0.3 eggshell, 0.5 satin, 0.8 glazed, 1 wet lacquer.
// Example: #for (I, 0, 4) sphere { <0.9*(I - 2), 0, 0>, 0.45 pigment { rgb <0.1, 0.3, 0.5> } finish {
//   GlossyFinish(I/4) } } #end
#macro GlossyFinish(Gloss)
  #local Mirror_ = max(0, min(1, 2*Gloss - 1));
  ambient 0.08
  diffuse 0.85 - 0.2*Mirror_
  specular albedo 0.045*min(1, 3*Gloss)
  // From a highlight of 60 degrees to one of 3.
  roughness 0.3*pow(0.005, Gloss)
  #if (Mirror_ > 0)
    reflection { 0.04*Mirror_, 0.35*Mirror_ falloff 5 }
  #end
#end

// MetalFinish(Polish)
// Any metal: light is mirrored and shines in the colour of the pigment.
// Polish: 0 matt as if cast, 0.5 satin, 1 a mirror.
// Example: #for (I, 0, 4) sphere { <0.9*(I - 2), 0, 0>, 0.45 pigment { rgb <0.95, 0.64, 0.54> } finish {
//   MetalFinish(I/4) } } #end
#macro MetalFinish(Polish)
  ambient 0.06*(1 - Polish)
  diffuse 0.5 - 0.44*Polish
  brilliance 1 + 3*Polish
  specular albedo 0.4
  roughness 0.16*pow(0.015, Polish)
  metallic
  reflection { 0.08 + 0.72*Polish, 0.45 + 0.47*Polish falloff 4 metallic }
#end

// ---- Plain surfaces -------------------------------------------------------------------------------------------------

// MatteFinish: finish. No shine at all: unglazed clay, blotting paper.
#declare MatteFinish = finish { ambient 0.08 diffuse 0.85 }
// ChalkFinish: finish. Matt and flat, as rough grounds look: plaster, bone, the moon.
#declare ChalkFinish = finish { ambient 0.08 diffuse 0.85 brilliance 0.75 }
// EggshellFinish: finish. A wide, faint sheen.
#declare EggshellFinish = finish { GlossyFinish(0.3) }
// SatinFinish: finish. A soft highlight, no mirror: painted wood, leather, most living skins.
#declare SatinFinish = finish { GlossyFinish(0.5) }
// GlazedFinish: finish. A clear highlight and a faint mirror: porcelain, polished stone.
#declare GlazedFinish = finish { GlossyFinish(0.8) }
// WetFinish: finish. The sharpest highlights and a mirror at the rims: fresh paint, wet sand, eyes.
#declare WetFinish = finish { GlossyFinish(1) }

// ---- Bodies that light enters ---------------------------------------------------------------------------------------

// WaxFinish: finish. Light goes in and round: soft from light to shadow, with a sheen that is broad and a little sharp.
#declare WaxFinish = finish { ambient 0.1 diffuse 0.79 brilliance 0.6 specular albedo 0.03
  roughness 0.06 phong albedo 0.01 phong_size 160 }
// FleshFinish: finish. Skin, fruit and petals: soft shadows and a moist sheen.
#declare FleshFinish = finish { ambient 0.09 diffuse 0.82 brilliance 0.75 specular albedo 0.04 roughness 0.05 }
// JellyFinish: finish. For what is half transparent: highlights are sharp. It has no mirror, which would make each ray
// two at every wall, so that it costs much less than glass.
#declare JellyFinish = finish { ambient 0.05 diffuse 0.75 brilliance 0.6 specular albedo 0.045 roughness 0.003 }
// GlassFinish: finish. For glass and water: nothing is scattered; mirrors by the `ior` of the interior, which it needs.
#declare GlassFinish = finish { ambient 0 diffuse 0 specular albedo 0.04 roughness 0.001
  reflection { 0, 1 fresnel } conserve_energy }

// ---- Sheens ---------------------------------------------------------------------------------------------------------

// PearlFinish: finish. A silky sheen in colours that barely change with the angle: pearls, nacre, silk.
#declare PearlFinish = finish { ambient 0.08 diffuse 0.72 specular albedo 0.12 roughness 0.03
  reflection { 0.03, 0.25 falloff 3 } irid { 0.18 thickness 0.55 } }
// OilFilmFinish: finish. Strong colours of a thin film: soap, oil, the throat of a hummingbird. Best on dark pigments.
#declare OilFilmFinish = finish { ambient 0.04 diffuse 0.4 specular albedo 0.25 roughness 0.04
  reflection { 0.08, 0.6 falloff 3 } irid { 0.6 thickness 0.8 turbulence 0.3 } }
// DustFinish: finish. Flat and bright towards the rims of the light, as dust and velvet are.
#declare DustFinish = finish { ambient 0.08 diffuse 0.74 brilliance 0.5 }
// GlowFinish: finish. Shines by itself, evenly: lamps, lava, deep-sea lights. It lights other things with
// `bounce_light`.
#declare GlowFinish = finish { ambient 0 diffuse 0.1 emission 0.9 }

// ---- Textures between textures --------------------------------------------------------------------------------------

// MixTextures(First, Second, Share)
// A texture between two others, for things that change from piece to piece: along a tail, from the stem to the tips. It
// costs as much as both.
// First, Second: textures of one layer each. Share: 0 gives First alone, 1 Second.
// Example: #declare Clay = texture { pigment { rgb <0.4, 0.2, 0.1> } finish { MatteFinish } }
//   #declare Glaze = texture { pigment { rgb <0.05, 0.3, 0.3> } finish { WetFinish } }
//   blob { kernel "gaussian" #for (I, 0, 4) sphere { (0.6*I - 1.2)*x, 0.5 MixTextures(Clay, Glaze, I/4) } #end }
#macro MixTextures(First, Second, Share)
  #if (Share <= 0)
    texture { First }
  #elseif (Share >= 1)
    texture { Second }
  #else
    texture { average texture_map { [1 - Share First] [Share Second] } }
  #end
#end

#version Finishes_Isl_Before;
#end
