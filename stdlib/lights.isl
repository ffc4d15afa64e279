// Lights that find their own place: a studio about an object, sun and sky by the hour, windows and lamps.
//
//   #include "lights.isl"
//   #declare Thing = blob { … }
//   object { Thing }
//   SoftStudio(Thing, <1, 0.6, -3>)                        lights, surroundings and soft shadows in one line
//   SunAndSky(12, 60, 0.3)                                 or the light of a late afternoon
//
// From is the direction from the object to the camera, as in cameras.isl; left and right are as that camera sees them.
// The object must be bounded: give the plant without the ground it stands on. Lights do not fade with the distance
// unless it is said, so that they are as bright on a coral as on a cathedral. y is up.
#ifndef (Lights_Isl_Before)
#declare Lights_Isl_Before = version;
#version 3.7;
#include "skies.isl"

// ---- Colours of light -----------------------------------------------------------------------------------------------

// KelvinColour(Temperature)
// The colour of a lamp by its temperature, its greatest component 1.
// Temperature: kelvin; 1900 candle, 2700 bulb, 4000 moonlit white, 5500 flash, 6500 white of the screen, 10000 shade.
// The chromaticity is the cubic fit to Planck's law by B. Kim et al., "Design of Advanced Color Temperature Control
// System for HDTV Applications" (2002), good from 1667 to 25000.
// Example: sphere { 0, 1 pigment { KelvinColour(2700) } }
#macro KelvinColour(Temperature)
  #local T_ = 1000/max(1667, min(25000, Temperature));
  #if (Temperature < 4000)
    #local X_ = -0.2661239*T_*T_*T_ - 0.2343589*T_*T_ + 0.8776956*T_ + 0.179910;
  #else
    #local X_ = -3.0258469*T_*T_*T_ + 2.1070379*T_*T_ + 0.2226347*T_ + 0.240390;
  #end
  #if (Temperature < 2222)
    #local Y_ = -1.1063814*X_*X_*X_ - 1.34811020*X_*X_ + 2.18555832*X_ - 0.20219683;
  #elseif (Temperature < 4000)
    #local Y_ = -0.9549476*X_*X_*X_ - 1.37418593*X_*X_ + 2.09137015*X_ - 0.16748867;
  #else
    #local Y_ = 3.0817580*X_*X_*X_ - 5.87338670*X_*X_ + 3.75112997*X_ - 0.37001483;
  #end
  // From chromaticity, at the luminance 1, to the linear light of sRGB (IEC 61966-2-1).
  #local Xyz_ = <X_/Y_, 1, (1 - X_ - Y_)/Y_>;
  #local Light_ = <max(0, vdot(Xyz_, <3.2406, -1.5372, -0.4986>)), max(0, vdot(Xyz_, <-0.9689, 1.8758, 0.0415>)),
                   max(0, vdot(Xyz_, <0.0557, -0.2040, 1.0570>))>;
  #local Colour_ = rgb Light_/max(Light_.x, Light_.y, Light_.z);
  Colour_
#end

// ---- About an object ------------------------------------------------------------------------------------------------

// Declares Lights_Isl_Middle and Lights_Isl_Reach, the middle of an object's box and half its diagonal.
#macro Lights_Isl_Measure(Object)
  #local Low_ = min_extent(Object);
  #local High_ = max_extent(Object);
  #declare Lights_Isl_Middle = (Low_ + High_)/2;
  #declare Lights_Isl_Reach = max(1e-6, vlength(High_ - Low_)/2);
#end

// The direction that is Azimuth degrees to the right of From, as the camera sees it, and Elevation degrees above the
// horizon.
#macro Lights_Isl_Direction(From, Azimuth, Elevation)
  #local Heading_ = degrees(atan2(From.x, -From.z));
  SunDirection(Elevation, Heading_ + Azimuth)
#end

// LightFrom(Object, From, Azimuth, Elevation, Colour, Softness)
// One light, three diagonals of the object's box away; the studios are made of this.
// Azimuth: degrees from the camera's direction, positive on the right. Elevation: degrees above the horizon.
// Softness: width of the light as a share of its distance: 0 is a point with hard shadows, 0.3 a soft box, 0.8 a wall.
// Example: sphere { 0, 1 pigment { rgb 0.8 } } LightFrom(sphere { 0, 1 }, -z, -40, 35, rgb 1, 0)
#macro LightFrom(Object, From, Azimuth, Elevation, Colour, Softness)
  Lights_Isl_Measure(Object)
  #local Away_ = 6*Lights_Isl_Reach;
  light_source {
    Lights_Isl_Middle + Away_*Lights_Isl_Direction(From, Azimuth, Elevation), Colour
    #if (Softness > 0)
      area_light Softness*Away_*x, Softness*Away_*y, 8, 8 circular orient jitter
    #end
  }
#end

// FillFrom(Object, From, Azimuth, Elevation, Colour)
// A light without shadows or highlights, which brightens those of others.
// Azimuth, Elevation: as in LightFrom.
// Example: sphere { 0, 1 pigment { rgb 0.8 } } FillFrom(sphere { 0, 1 }, -z, 60, 10, rgb 0.3)
#macro FillFrom(Object, From, Azimuth, Elevation, Colour)
  Lights_Isl_Measure(Object)
  light_source { Lights_Isl_Middle + 6*Lights_Isl_Reach*Lights_Isl_Direction(From, Azimuth, Elevation), Colour
    shadowless }
#end

// StudioLights(Object, From)
// Key, fill and rim: a warm light from the upper left, a cool one without shadows from the right, one from behind that
// draws the outline. Points of light: quick, with hard shadows.
// From: direction to the camera.
// Example: sphere { 0, 1 pigment { rgb <0.8, 0.3, 0.2> } } StudioLights(sphere { 0, 1 }, -z)
#macro StudioLights(Object, From)
  StudioLightsBy(Object, From, 0, 1)
#end

// SoftStudioLights(Object, From)
// The same three with soft shadows.
// Example: sphere { 0, 1 pigment { rgb <0.8, 0.3, 0.2> } } SoftStudioLights(sphere { 0, 1 }, -z)
#macro SoftStudioLights(Object, From)
  StudioLightsBy(Object, From, 0.35, 1)
#end

// StudioLightsBy(Object, From, Softness, Contrast)
// The same three as one likes them.
// Softness: 0 hard, 0.35 soft, 0.8 very soft. Contrast: 0.5 gentle, 1 usual, 2 dramatic: the fill is divided by it.
// Example: sphere { 0, 1 pigment { rgb <0.8, 0.3, 0.2> } } StudioLightsBy(sphere { 0, 1 }, -z, 0, 2)
#macro StudioLightsBy(Object, From, Softness, Contrast)
  LightFrom(Object, From, -42, 42, rgb <1.00, 0.95, 0.88>, Softness)
  FillFrom(Object, From, 55, 12, rgb <0.19, 0.215, 0.25>/Contrast)
  LightFrom(Object, From, 155, 48, rgb <0.42, 0.46, 0.52>, 0.6*Softness)
#end

// SoftStudio(Object, From)
// A whole studio: the three soft lights, StudioSky for mirrors to show and for light from all around, and light that
// surfaces throw on one another.
// Example: sphere { 0, 1 pigment { rgb <0.8, 0.3, 0.2> } } SoftStudio(sphere { 0, 1 }, -z)
#macro SoftStudio(Object, From)
  // The sky is the fill light, and a part of the key.
  LightFrom(Object, From, -42, 42, rgb <0.62, 0.58, 0.53>, 0.35)
  LightFrom(Object, From, 155, 38, rgb <0.34, 0.37, 0.42>, 0.2)
  sky_sphere { StudioSky rotate -degrees(atan2(From.x, -From.z))*y }
  LightAround(Object)
#end

// LightAround(Object)
// Light from the sky, and between surfaces, within three diagonals of the object's box: creases go dark, colours bleed.
// Example: sphere { 0, 1 pigment { rgb <0.8, 0.3, 0.2> } } background { rgb 0.5 } LightAround(sphere { 0, 1 })
#macro LightAround(Object)
  Lights_Isl_Measure(Object)
  global_settings { sky_light { distance 6*Lights_Isl_Reach } bounce_light { distance 6*Lights_Isl_Reach } }
#end

// SpotOn(Object, From, Azimuth, Elevation, Colour, Softness)
// A theatre spot whose pool of light just holds the object.
// Azimuth, Elevation, Softness: as in LightFrom.
// Example: sphere { 0, 1 pigment { rgb 0.8 } } plane { y, -1 } SpotOn(sphere { 0, 1 }, -z, -30, 60, rgb 1.2, 0)
#macro SpotOn(Object, From, Azimuth, Elevation, Colour, Softness)
  Lights_Isl_Measure(Object)
  #local Away_ = 6*Lights_Isl_Reach;
  light_source {
    Lights_Isl_Middle + Away_*Lights_Isl_Direction(From, Azimuth, Elevation), Colour
    // The cone that touches the sphere about the box has an angle whose sine is 1/6.
    spotlight point_at Lights_Isl_Middle radius 8 falloff 14
    #if (Softness > 0)
      area_light Softness*Away_*x, Softness*Away_*y, 8, 8 circular orient jitter
    #end
  }
#end

// RimLights(Object, From)
// Two lights from behind, warm and cool, for dark pictures of outlines, hair and glass.
// Example: sphere { 0, 1 pigment { rgb 0.6 } } RimLights(sphere { 0, 1 }, -z)
#macro RimLights(Object, From)
  LightFrom(Object, From, 125, 20, rgb <1.1, 0.8, 0.5>, 0)
  LightFrom(Object, From, -125, 30, rgb <0.45, 0.75, 1.2>, 0)
#end

// ---- Sun, window, lamp ----------------------------------------------------------------------------------------------

// SunLight(Elevation, Azimuth, Haze)
// The sun alone: parallel light, the same everywhere.
// Elevation: degrees above the horizon. Azimuth: degrees from -z towards x, as in SunDirection. Haze: 0 clear … 1 mist.
// Example: sphere { 0, 1 pigment { rgb 0.8 } } SunLight(30, -40, 0.2)
#macro SunLight(Elevation, Azimuth, Haze)
  light_source { 1e4*SunDirection(Elevation, Azimuth), SunColour(Elevation, Haze) parallel point_at 0 }
#end

// SoftSunLight(Elevation, Azimuth, Haze, Width)
// The sun with soft shadows, wider the more haze there is.
// Width: of the sun in degrees: 0.5 as it is, 2 and more to be kind.
// Example: sphere { 0, 1 pigment { rgb 0.8 } } SoftSunLight(30, -40, 0.2, 2)
#macro SoftSunLight(Elevation, Azimuth, Haze, Width)
  #local Size_ = 2e4*tan(radians((Width + 6*Haze)/2));
  light_source {
    1e4*SunDirection(Elevation, Azimuth), SunColour(Elevation, Haze)
    area_light Size_*x, Size_*y, 8, 8 circular orient jitter
  }
#end

// SunAndSky(Elevation, Azimuth, Haze)
// The light of an hour out of doors: sky, sun and light from all around, in the units of a picture that is exposed for
// it.
// Elevation: 55 noon, 15 late afternoon, 3 sunset, -5 dusk. Azimuth: 0 behind a camera that looks along z, 90 to its
// right, 180 ahead. Haze: 0 mountain air, 0.3 a fine day, 1 mist without a sun.
// Example: sphere { 0, 1 pigment { rgb 0.8 } } plane { y, -1 pigment { rgb 0.5 } } SunAndSky(12, -60, 0.3)
#macro SunAndSky(Elevation, Azimuth, Haze)
  DaySky(Elevation, Azimuth, Haze)
  #if (Elevation > 0)
    SoftSunLight(Elevation, Azimuth, Haze, 1)
  #end
  global_settings { sky_light { } }
#end

// WindowLight(Object, From, Azimuth, Colour)
// A tall window beside the object, at its height: light that fades across the room and wraps around what it meets.
// Azimuth: degrees from the camera's direction; -80 is a painter's window on the left. Colour: 1.5 to 3 times white.
// Example: sphere { 0, 1 pigment { rgb 0.8 } } WindowLight(sphere { 0, 1 }, -z, -80, rgb <1.6, 1.75, 2>)
#macro WindowLight(Object, From, Azimuth, Colour)
  Lights_Isl_Measure(Object)
  #local To_ = Lights_Isl_Direction(From, Azimuth, 14);
  #local Side_ = vnormalize(vcross(To_, y));
  light_source {
    Lights_Isl_Middle + 2.6*Lights_Isl_Reach*To_, Colour
    area_light 1.5*Lights_Isl_Reach*Side_, 2.4*Lights_Isl_Reach*y, 5, 8 area_illumination jitter
    fade_distance 2*Lights_Isl_Reach fade_power 2
  }
#end

// BlindsLight(Object, From, Azimuth, Elevation, Colour, Slats)
// Sunlight through the slats of a blind: stripes of light on the object and what is around it.
// Azimuth, Elevation: as in LightFrom. Slats: gaps across the object, 5 to 12.
// Example: sphere { 0, 1 pigment { rgb 0.8 } } BlindsLight(sphere { 0, 1 }, -z, -50, 35, rgb <1.2, 1, 0.7>, 7)
#macro BlindsLight(Object, From, Azimuth, Elevation, Colour, Slats)
  Lights_Isl_Measure(Object)
  #local To_ = Lights_Isl_Direction(From, Azimuth, Elevation);
  #local Side_ = vnormalize(vcross(To_, y));
  #local Rise_ = vnormalize(vcross(Side_, To_));
  #local R_ = Lights_Isl_Reach;
  #local Gap_ = 2*R_/Slats;
  light_source {
    Lights_Isl_Middle + 40*R_*To_, Colour
    parallel point_at Lights_Isl_Middle
    projected_through {
      union {
        #for (Slat_, -floor(Slats/2) - 1, floor(Slats/2) + 1)
          box { <-2*R_, (Slat_ - 0.28)*Gap_, -R_/100>, <2*R_, (Slat_ + 0.28)*Gap_, R_/100> }
        #end
        matrix <Side_.x, Side_.y, Side_.z, Rise_.x, Rise_.y, Rise_.z, To_.x, To_.y, To_.z,
                Lights_Isl_Middle.x + 2*R_*To_.x, Lights_Isl_Middle.y + 2*R_*To_.y, Lights_Isl_Middle.z + 2*R_*To_.z>
      }
    }
  }
#end

// LampLight(Place, Colour, Reach)
// A lamp that fades as lamps do, and is seen as a small glowing ball.
// Place: its middle. Colour: of the light at Reach. Reach: the distance at which it is that bright; the ball is a
// twentieth.
// Example: sphere { 0, 0.6 pigment { rgb 0.8 } } LampLight(<-1, 1, -1>, KelvinColour(2700), 1.5)
#macro LampLight(Place, Colour, Reach)
  light_source {
    Place, Colour
    fade_distance Reach fade_power 2
    looks_like { sphere { 0, Reach/20 pigment { Colour } finish { ambient 0 diffuse 0 emission 3 } } }
  }
#end

#version Lights_Isl_Before;
#end
