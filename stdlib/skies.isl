// Skies: what is behind a scene, what its mirrors show, and with `sky_light` what lights it. y is up.
//
//   #include "skies.isl"
//   sky_sphere { CumulusSky }
//   DaySky(20, 60, 0.3)                                    a sky by the height of the sun
//   global_settings { sky_light { distance 10 } }          lets the sky light the scene
//
// Skies that are declared are of the kind sky_sphere; turn one with `sky_sphere { CumulusSky rotate 40*y }`. Suns and
// soft boxes are brighter than 1, as they are to a camera; the rest is about as bright as a well-lit surface. Below
// the horizon there is what a floor would throw back, so that a scene without ground is lit from below, too.
#ifndef (Skies_Isl_Before)
#declare Skies_Isl_Before = version;
#version 3.7;

// ---- Parts ----------------------------------------------------------------------------------------------------------

// Red, green and blue of a colour, a vector or a number, as a vector.
#macro Skies_Isl_Light(Colour)
  #local Any_ = <0, 0, 0> + Colour;
  <Any_.red, Any_.green, Any_.blue>
#end

// SkyGradient(Nadir, Horizon, Zenith)
// A sky of three colours, soft at the horizon.
// Nadir, Horizon, Zenith: colours in linear light, below, ahead and above.
// Example: sky_sphere { SkyGradient(rgb 0.2, rgb <1, 0.8, 0.6>, rgb <0.2, 0.4, 0.8>) }
//   sphere { 0, 1 finish { reflection 1 } }
#macro SkyGradient(Nadir, Horizon, Zenith)
  pigment {
    gradient y
    color_map {
      [0 Nadir]
      [0.47 0.5*Nadir + 0.5*Horizon]
      [0.5 Horizon]
      [0.56 0.75*Horizon + 0.25*Zenith]
      [0.68 0.3*Horizon + 0.7*Zenith]
      [1 Zenith]
    }
    scale 2 translate -y
  }
#end

// SkyLamp(Direction, Width, Colour)
// A round soft light in the sky, a layer of a sky_sphere: a sun with its glow, a moon, a lamp that mirrors show.
// Direction: to the lamp. Width: degrees across. Colour: brightness in the middle; it fades towards the rim.
// Example: sky_sphere { SkyGradient(rgb 0.05, rgb 0.1, rgb 0.05) SkyLamp(<-1, 1, -1>, 40, rgb 4) }
//   sphere { 0, 1 finish { reflection 1 } }
#macro SkyLamp(Direction, Width, Colour)
  #local Shine_ = Skies_Isl_Light(Colour);
  pigment {
    spherical
    color_map {
      [0 rgbt <0, 0, 0, 1>]
      [0.25 rgbt <Shine_.x, Shine_.y, Shine_.z, 0.85>]
      [0.6 rgbt <Shine_.x, Shine_.y, Shine_.z, 0.15>]
      [0.75 rgb Shine_]
    }
    scale 2*sin(radians(Width/4)) translate vnormalize(Direction)
  }
#end

// SkyPanel(Direction, Width, Height, Colour)
// A rectangular soft box in the sky, a layer of a sky_sphere: what metals and glass mirror in a studio.
// Direction: to its middle. Width, Height: degrees. Colour: its brightness, 2 to 6.
// Example: sky_sphere { SkyGradient(rgb 0.05, rgb 0.1, rgb 0.05) SkyPanel(<-1, 1, -1>, 30, 60, rgb 4) }
//   sphere { 0, 1 finish { reflection 1 } }
#macro SkyPanel(Direction, Width, Height, Colour)
  #local Shine_ = Skies_Isl_Light(Colour);
  #local To_ = vnormalize(Direction);
  pigment {
    boxed
    color_map { [0 rgbt <Shine_.x, Shine_.y, Shine_.z, 1>] [0.16 rgb Shine_] }
    scale <sin(radians(Width/2)), sin(radians(Height/2)), 0.6>
    translate z
    rotate -degrees(asin(To_.y))*x
    rotate degrees(atan2(To_.x, To_.z))*y
  }
#end

// AboveHorizon(Pigment)
// A pigment that is seen above the horizon only, a layer of a sky_sphere.
// Pigment: one that is clear in part, for clouds, or a whole one.
// Example: sky_sphere { SkyGradient(rgb 0.3, rgb 0.8, rgb <0.1, 0.3, 0.8>) AboveHorizon(pigment { bozo color_map {
//   [0.4 rgbt 1] [1 rgb 1] } scale 0.3 }) } sphere { 0, 1 finish { reflection 1 } }
#macro AboveHorizon(Pigment)
  pigment {
    gradient y
    pigment_map { [0.495 rgbt <1, 1, 1, 1>] [0.53 Pigment translate y scale 0.5] }
    scale 2 translate -y
  }
#end

// CloudLayer(Cover, Size, Lit, Shade)
// Clouds, a layer of a sky_sphere; they lie flat and close up towards the horizon.
// Cover: share of the sky, 0.2 few to 0.8 many. Size: of a cloud, 0.3 usual. Lit, Shade: colours of thin and thick
// parts.
// Example: sky_sphere { SkyGradient(rgb 0.3, rgb 0.8, rgb <0.1, 0.3, 0.8>) CloudLayer(0.5, 0.3, rgb 1, rgb 0.6) }
//   sphere { 0, 1 finish { reflection 1 } }
#macro CloudLayer(Cover, Size, Lit, Shade)
  #local Lit_ = Skies_Isl_Light(Lit);
  #local Edge_ = 1 - Cover;
  AboveHorizon(pigment {
    bozo
    turbulence 0.55 octaves 5 omega 0.55 lambda 2.2
    color_map {
      [max(0, 0.85*Edge_) rgbt <Lit_.x, Lit_.y, Lit_.z, 1>]
      [min(0.98, 0.85*Edge_ + 0.14) rgbt <Lit_.x, Lit_.y, Lit_.z, 0.25>]
      [min(0.99, 0.85*Edge_ + 0.3) rgbt <Lit_.x, Lit_.y, Lit_.z, 0.03>]
      [1 Shade]
    }
    scale Size*<1, 0.28, 1>
  })
#end

// ---- By the height of the sun ---------------------------------------------------------------------------------------

// What light is like when the sun is so many degrees high: <red, green, blue> of the sun, of the sky above, at the
// horizon, and of the glow about the sun.
// Our own readings of photographs: a sun goes from white to amber to red, and the sky's light fades below the horizon.
#declare Skies_Isl_Sun = spline { linear_spline
  -8, <0, 0, 0>, -3, <0.05, 0.01, 0>, 0, <0.62, 0.19, 0.04>, 4, <0.95, 0.44, 0.16>, 10, <1.10, 0.72, 0.38>,
    25, <1.18, 0.98, 0.72>
  60, <1.20, 1.10, 0.94>, 90, <1.20, 1.12, 0.98> }
#declare Skies_Isl_Zenith = spline { linear_spline
  -18, <0.002, 0.003, 0.008>, -8, <0.012, 0.020, 0.055>, 0, <0.08, 0.13, 0.27>, 6, <0.12, 0.22, 0.44>,
    25, <0.11, 0.26, 0.58>
  60, <0.09, 0.25, 0.64>, 90, <0.08, 0.24, 0.66> }
#declare Skies_Isl_Horizon = spline { linear_spline
  -18, <0.004, 0.005, 0.010>, -8, <0.05, 0.05, 0.085>, 0, <0.40, 0.29, 0.27>, 6, <0.66, 0.53, 0.43>,
    25, <0.66, 0.72, 0.76>,
  60, <0.58, 0.74, 0.88>, 90, <0.56, 0.74, 0.90> }
#declare Skies_Isl_Glow = spline { linear_spline
  -18, <0.004, 0.004, 0.006>, -8, <0.34, 0.12, 0.05>, 0, <1.05, 0.44, 0.16>, 6, <1.10, 0.70, 0.38>,
    25, <1.05, 0.98, 0.88>,
  60, <1, 1, 0.98>, 90, <1, 1, 0.98> }

// SunDirection(Elevation, Azimuth)
// The direction to the sun, of length 1.
// Elevation: degrees above the horizon. Azimuth: degrees from -z, where a camera that looks along z stands, towards x:
// 0 is behind that camera, 90 to its right, 180 ahead.
// Example: sphere { 0, 0.5 pigment { rgb 0.5 } } sphere { SunDirection(30, 45), 0.15 pigment { rgb <1, 0.8, 0.3> } }
#macro SunDirection(Elevation, Azimuth)
  <sin(radians(Azimuth))*cos(radians(Elevation)), sin(radians(Elevation)),
   -cos(radians(Azimuth))*cos(radians(Elevation))>
#end

// SunColour(Elevation, Haze)
// The light of the sun as it gets to the ground: a colour for a light_source.
// Elevation: degrees; from white at noon over amber at 10 to red at 0. Haze: 0 mountain air, 0.3 a fine day, 1 mist.
// Example: sphere { 0, 1 pigment { SunColour(5, 0.3) } }
#macro SunColour(Elevation, Haze)
  #local Sun_ = <0, 0, 0> + Skies_Isl_Sun(Elevation);
  #local Colour_ = rgb Sun_*<1 - 0.55*Haze, 1 - 0.6*Haze, 1 - 0.7*Haze>;
  Colour_
#end

// SkyColour(Elevation, Haze)
// The mean colour of that sky, for fog and fill lights.
// Elevation: degrees of the sun. Haze: as in SunColour.
// Example: fog { distance 20 SkyColour(10, 0.5) } sphere { 0, 1 pigment { rgb 0.5 } }
#macro SkyColour(Elevation, Haze)
  #local Above_ = <0, 0, 0> + Skies_Isl_Zenith(Elevation);
  #local Ahead_ = <0, 0, 0> + Skies_Isl_Horizon(Elevation);
  #local Colour_ = rgb 0.5*Above_*(1 - Haze) + 0.5*Ahead_*(1 + 0.3*Haze);
  Colour_
#end

// DaySky(Elevation, Azimuth, Haze)
// The sky_sphere of any hour without clouds, with the sun's disc and its glow.
// Elevation: of the sun, degrees; 60 noon, 20 afternoon, 3 sunset, -6 dusk. Azimuth: as in SunDirection. Haze: 0 deep
// blue, 0.3 a fine day, 1 white mist.
// Example: DaySky(4, 160, 0.3) sphere { 0, 1 finish { reflection 1 diffuse 0 } }
#macro DaySky(Elevation, Azimuth, Haze)
  sky_sphere { DaySkyLayers(Elevation, Azimuth, Haze) }
#end

// DaySkyLayers(Elevation, Azimuth, Haze)
// The pigments of DaySky, so that clouds can be laid over them.
// Example: sky_sphere { DaySkyLayers(20, 160, 0.2) CloudLayer(0.4, 0.3, rgb 1, rgb 0.5) }
//   sphere { 0, 1 finish { reflection 1 } }
#macro DaySkyLayers(Elevation, Azimuth, Haze)
  #local Above_ = <0, 0, 0> + Skies_Isl_Zenith(Elevation);
  #local Ahead_ = <0, 0, 0> + Skies_Isl_Horizon(Elevation);
  #local Sun_ = <0, 0, 0> + Skies_Isl_Sun(Elevation);
  #local Grey_ = vdot(Ahead_, <0.3, 0.5, 0.2>);
  #local Zenith_ = Above_ + 0.75*Haze*(Grey_*<1, 1, 1.05> - Above_);
  #local Horizon_ = Ahead_ + 0.3*Haze*(Grey_ - Ahead_);
  #local To_ = SunDirection(Elevation, Azimuth);
  SkyGradient(rgb Horizon_*<0.42, 0.38, 0.34>, rgb Horizon_, rgb Zenith_)
  // The glow about the sun is wider and fainter the more haze there is.
  #local Glow_ = <0, 0, 0> + Skies_Isl_Glow(Elevation);
  SkyGlow(To_, 75 + 70*Haze, rgb Glow_)
  SkyGlow(To_, 14 + 12*Haze, rgb Glow_ + 1.5*Sun_)
  #if (Elevation > -0.3 & Haze < 0.9)
    SkyLamp(To_, 1.2, rgb 60*(1 - Haze)*Sun_)
  #end
#end

// SkyGlow(Direction, Width, Colour)
// A wide glow without an edge, a layer of a sky_sphere.
// Direction: to its middle. Width: degrees across. Colour: in the middle.
// Example: sky_sphere { SkyGradient(rgb 0.05, rgb 0.1, rgb 0.05) SkyGlow(<-1, 0.2, 1>, 90, rgb <1, 0.4, 0.2>) } sphere
//   { 0, 1 finish { reflection 1 } }
#macro SkyGlow(Direction, Width, Colour)
  #local Shine_ = Skies_Isl_Light(Colour);
  pigment {
    spherical
    poly_wave 2
    color_map { [0 rgbt <Shine_.x, Shine_.y, Shine_.z, 1>] [1 rgbt <Shine_.x, Shine_.y, Shine_.z, 0.1>] }
    scale 2*sin(radians(min(180, Width/2)/2)) translate vnormalize(Direction)
  }
#end

// ---- Declared skies -------------------------------------------------------------------------------------------------

// StudioSky: sky_sphere. A photographer's studio: a large soft box on the left, a narrow one on the right, one above,
// a grey floor. For products, metals and glass.
#declare StudioSky = sky_sphere {
  SkyGradient(rgb 0.13, rgb 0.22, rgb 0.28)
  SkyPanel(<-0.9, 0.7, -0.5>, 52, 48, rgb <2.2, 2.1, 1.95>)
  SkyPanel(<1, 0.25, -0.25>, 15, 72, rgb <1.3, 1.45, 1.65>)
  SkyPanel(<0.15, 0.55, 1>, 66, 18, rgb 0.9)
}
// DarkStudioSky: sky_sphere. Two narrow lights in a black room, for glass, jewels and gold.
#declare DarkStudioSky = sky_sphere {
  SkyGradient(rgb 0.01, rgb 0.025, rgb 0.015)
  SkyPanel(<-1, 0.3, -0.2>, 16, 80, rgb 3.5)
  SkyPanel(<1, 0.35, 0.35>, 24, 70, rgb <2.2, 2.5, 3>)
  SkyPanel(<0, 1, 0.15>, 50, 26, rgb 1.6)
}
// PaperSky: sky_sphere. A seamless white background with a touch of grey above.
#declare PaperSky = sky_sphere { SkyGradient(rgb 0.72, rgb 0.86, rgb 0.74) }
// MorningSky: sky_sphere. A low sun on the right, clear and cool.
#declare MorningSky = sky_sphere { DaySkyLayers(9, 110, 0.2) }
// NoonSky: sky_sphere. A blue sky with the sun behind the camera.
#declare NoonSky = sky_sphere { DaySkyLayers(55, -35, 0.2) }
// SunsetSky: sky_sphere. A red sun ahead on the left, with bars of cloud.
#declare SunsetSky = sky_sphere {
  DaySkyLayers(2.5, 205, 0.2)
  AboveHorizon(pigment {
    bozo turbulence 0.35 octaves 4 omega 0.5
    color_map {
      [0.48 rgbt <0.9, 0.42, 0.25, 1>] [0.62 rgbt <0.85, 0.34, 0.24, 0.35>] [0.8 rgbt <0.34, 0.15, 0.2, 0.25>]
        [1 rgb <0.2, 0.1, 0.17>] }
    scale <0.9, 0.07, 0.9>
  })
}
// DuskSky: sky_sphere. After sunset: indigo above, a band of rose, embers at the horizon.
#declare DuskSky = sky_sphere {
  pigment {
    gradient y
    color_map {
      [0 rgb <0.02, 0.02, 0.04>] [0.48 rgb <0.10, 0.05, 0.07>] [0.5 rgb <0.95, 0.42, 0.14>]
        [0.53 rgb <0.62, 0.24, 0.17>]
      [0.58 rgb <0.26, 0.13, 0.21>] [0.68 rgb <0.075, 0.07, 0.18>] [1 rgb <0.012, 0.018, 0.07>]
    }
    scale 2 translate -y
  }
}
// CumulusSky: sky_sphere. Fair weather: white heaps of cloud on blue.
#declare CumulusSky = sky_sphere {
  DaySkyLayers(48, -50, 0.15)
  CloudLayer(0.5, 0.3, rgb <0.92, 0.93, 0.95>, rgb <0.5, 0.54, 0.62>)
}
// CirrusSky: sky_sphere. Thin streaks of ice high up.
#declare CirrusSky = sky_sphere {
  DaySkyLayers(38, 60, 0.1)
  AboveHorizon(pigment {
    bozo turbulence <0.9, 0.3, 0.4> octaves 5 omega 0.62
    color_map { [0.38 rgbt 1] [0.8 rgbt <0.95, 0.97, 1, 0.35>] [1 rgbt <1, 1, 1, 0.15>] }
    scale <0.9, 0.12, 0.3> rotate 25*y
  })
}
// OvercastSky: sky_sphere. Grey, bright above: soft light without shadows.
#declare OvercastSky = sky_sphere {
  SkyGradient(rgb 0.2, rgb <0.52, 0.54, 0.57>, rgb <0.82, 0.84, 0.88>)
  AboveHorizon(pigment {
    bozo turbulence 0.6 octaves 4
    color_map { [0.3 rgbt <0.9, 0.9, 0.92, 1>] [0.7 rgbt <0.42, 0.44, 0.48, 0.45>] [1 rgbt <0.35, 0.37, 0.41, 0.35>] }
    scale <0.6, 0.16, 0.6>
  })
}
// StormSky: sky_sphere. Heavy clouds and a gap of light at the horizon.
#declare StormSky = sky_sphere {
  SkyGradient(rgb 0.04, rgb <0.62, 0.58, 0.46>, rgb <0.10, 0.12, 0.16>)
  AboveHorizon(pigment {
    granite turbulence 0.4 octaves 4
    color_map { [0.2 rgbt <0.05, 0.06, 0.09, 0.1>] [0.45 rgbt <0.14, 0.16, 0.2, 0.4>] [0.7 rgbt <0.5, 0.5, 0.5, 1>] }
    scale <2.4, 0.7, 2.4>
  })
}
// StarrySky: sky_sphere. A clear night: stars of several sizes and a faint band of milk.
#declare StarrySky = sky_sphere {
  SkyGradient(rgb <0.001, 0.001, 0.002>, rgb <0.012, 0.016, 0.030>, rgb <0.002, 0.004, 0.012>)
  pigment {
    planar turbulence 0.35 octaves 5 omega 0.6
    color_map { [0.5 rgbt <0.05, 0.055, 0.075, 1>] [1 rgbt <0.06, 0.06, 0.075, 0.4>] }
    rotate <50, 20, 35>
  }
  pigment {
    crackle form <1, 0, 0>
    color_map { [0.018 rgb <1.6, 1.6, 1.5>] [0.034 rgbt <0.5, 0.6, 0.9, 1>] }
    scale 0.055
  }
  pigment {
    crackle form <1, 0, 0>
    color_map { [0.010 rgb <3, 2.7, 2.3>] [0.02 rgbt <1, 0.6, 0.4, 1>] }
    scale 0.16 translate 7
  }
}
// NebulaSky: sky_sphere. Glowing gas between the stars, for scenes of no place.
#declare NebulaSky = sky_sphere {
  StarrySky
  pigment {
    wrinkles turbulence 0.5 octaves 4 omega 0.6
    color_map {
      [0.28 rgbt <0.02, 0.02, 0.08, 1>] [0.45 rgbt <0.10, 0.03, 0.16, 0.5>] [0.6 rgbt <0.34, 0.07, 0.20, 0.3>]
      [0.74 rgbt <0.75, 0.26, 0.20, 0.15>] [0.9 rgb <1, 0.72, 0.5>] }
    scale 1.3
  }
  pigment {
    bozo turbulence 0.7 octaves 4
    color_map { [0.5 rgbt <0, 0.1, 0.2, 1>] [1 rgbt <0.02, 0.30, 0.40, 0.35>] }
    scale 0.8 translate 3
  }
}
// DeepWaterSky: sky_sphere. Under the sea: light from the surface above, blue dark below.
#declare DeepWaterSky = sky_sphere {
  pigment {
    gradient y
    color_map {
      [0 rgb <0.002, 0.008, 0.02>] [0.4 rgb <0.006, 0.035, 0.07>] [0.6 rgb <0.02, 0.14, 0.22>]
        [0.85 rgb <0.12, 0.48, 0.55>]
      [0.96 rgb <0.65, 0.98, 0.92>] [1 rgb <1.3, 1.5, 1.35>]
    }
    scale 2 translate -y
  }
}
// AuroraSky: sky_sphere. Green curtains of northern light over a dark horizon.
#declare AuroraSky = sky_sphere {
  StarrySky
  pigment {
    marble turbulence <0.8, 0.02, 0.8> octaves 3 omega 0.42
    pigment_map {
      [0.5 rgbt <0, 0.3, 0.2, 1>]
      [0.86 gradient y color_map { [0.05 rgbt <0, 0.5, 0.3, 1>] [0.09 rgbt <0.16, 0.85, 0.40, 0.1>]
        [0.3 rgbt <0.05, 0.42, 0.32, 0.55>]
        [0.7 rgbt <0.28, 0.08, 0.42, 1>] } turbulence <0, 0.12, 0> octaves 5 omega 0.7 ]
      [0.9 rgbt <0, 0.3, 0.2, 1>]
    }
    scale <0.8, 1, 0.8> rotate 30*y
  }
}

#version Skies_Isl_Before;
#end
