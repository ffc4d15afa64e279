// Cameras that find their own place: they fit an object's box into the picture, whatever the picture's shape.
//
//   #include "cameras.isl"
//   #declare Thing = blob { … }
//   object { Thing }
//   FitCamera(Thing, <1, 0.6, -3>, 35)
//
// From is a direction throughout: from the middle of the object to the camera, of any length. <0, 0, -1> is from the
// front, <1, 0.6, -1> from the right and above. y is up. The object must be bounded: give the plant without the ground
// it stands on.
#ifndef (Cameras_Isl_Before)
#declare Cameras_Isl_Before = version;
#version 3.7;

// Declares the axes of a view: Cameras_Isl_Back (towards the camera), Cameras_Isl_Right, Cameras_Isl_Up.
#macro Cameras_Isl_Axes(From)
  #declare Cameras_Isl_Back = vnormalize(From);
  #if (abs(Cameras_Isl_Back.y) > 0.9999)
    #declare Cameras_Isl_Right = x;
  #else
    #declare Cameras_Isl_Right = vnormalize(vcross(Cameras_Isl_Back, y));
  #end
  #declare Cameras_Isl_Up = vnormalize(vcross(Cameras_Isl_Right, Cameras_Isl_Back));
  // The hand of the language: x is right where the camera looks along z with y above.
  #if (vdot(vcross(Cameras_Isl_Up, -Cameras_Isl_Back), Cameras_Isl_Right) < 0)
    #declare Cameras_Isl_Right = -Cameras_Isl_Right;
  #end
  #declare Cameras_Isl_Up = (Cameras_Isl_Up.y < -1e-6 ? -1 : 1)*Cameras_Isl_Up;
#end

// FitDistance(Object, From, Angle)
// How far from the middle of the object's box a camera has to stand so that the whole box is just inside the picture.
// Angle: degrees across the picture; 20 to 30 flatters, 35 is ordinary, 60 and more is dramatic.
// Example: #declare Ball = sphere { 0, 1 pigment { rgb 0.8 } } object { Ball } camera { location -FitDistance(Ball,
//   -z, 35)*z look_at 0
//   angle 35 }
#macro FitDistance(Object, From, Angle)
  #local Low_ = min_extent(Object);
  #local Half_ = (max_extent(Object) - Low_)/2;
  Cameras_Isl_Axes(From)
  #local Wide_ = tan(radians(Angle/2));
  #local High_ = Wide_*image_height/image_width;
  #local Distance_ = 0;
  // Each corner has to be within the four planes that bound the view.
  #for (I_, -1, 1, 2) #for (J_, -1, 1, 2) #for (K_, -1, 1, 2)
    #local Corner_ = Half_*<I_, J_, K_>;
    #local Near_ = vdot(Corner_, Cameras_Isl_Back);
    #local Distance_ = max(Distance_, Near_ + abs(vdot(Corner_, Cameras_Isl_Right))/Wide_,
                           Near_ + abs(vdot(Corner_, Cameras_Isl_Up))/High_);
  #end #end #end
  (Distance_)
#end

// FitCamera(Object, From, Angle)
// The object in the middle of the picture, with a margin of a twelfth.
// From: direction to the camera. Angle: degrees across the picture; 35 is ordinary.
// Example: object { torus { 1, 0.3 } pigment { rgb 0.8 } } FitCamera(torus { 1, 0.3 }, <1, 1, -2>, 35)
#macro FitCamera(Object, From, Angle)
  PlacedCamera(Object, From, Angle, 1.12, <0, 0>)
#end

// PlacedCamera(Object, From, Angle, Room, Place)
// The object anywhere in the picture, with as much room as wanted; the other cameras are made of this one.
// Room: 1 fills the picture, 1.5 leaves a third of it free. Place: where the middle of the object is to be, <right,
// up>, from <-0.5, -0.5>, the lower left corner, to <0.5, 0.5>.
// Example: object { torus { 1, 0.3 } pigment { rgb 0.8 } } PlacedCamera(torus { 1, 0.3 }, <1, 1, -2>, 35, 1.6, <-0.15,
//   0>)
#macro PlacedCamera(Object, From, Angle, Room, Place)
  #local Distance_ = Room*FitDistance(Object, From, Angle);
  #local Place_ = <0, 0> + Place;
  #local Middle_ = (min_extent(Object) + max_extent(Object))/2;
  #local Width_ = 2*Distance_*tan(radians(Angle/2));
  #local Aim_ = Middle_ - Place_.x*Width_*Cameras_Isl_Right - Place_.y*Width_*image_height/image_width*Cameras_Isl_Up;
  camera {
    location Aim_ + Distance_*Cameras_Isl_Back
    sky Cameras_Isl_Up
    look_at Aim_
    right x*image_width/image_height
    angle Angle
  }
#end

// GoldenCamera(Object, From, Angle, Side)
// The object on the line that divides the picture by the golden section, the larger part of the picture free beside it.
// Side: -1 puts the object on the left, 1 on the right.
// Example: object { torus { 1, 0.3 } pigment { rgb 0.8 } } GoldenCamera(torus { 1, 0.3 }, <1, 1, -2>, 35, -1)
#macro GoldenCamera(Object, From, Angle, Side)
  // 0.118 is what 0.382, the lesser part of the section, is away from the middle. The room keeps the object whole.
  PlacedCamera(Object, From, Angle, 1.62, <0.118*Side, -0.03>)
#end

// TurntableCamera(Object, Elevation, Angle, Turn)
// Goes around the object, at a distance that does not change, for films: Turn is then the clock.
// Elevation: degrees above the horizon; 20 is usual. Turn: 0 from the front, 0.25 from the right, 1 once around.
// Example: object { torus { 1, 0.3 } pigment { rgb 0.8 } } TurntableCamera(torus { 1, 0.3 }, 20, 35, clock)
#macro TurntableCamera(Object, Elevation, Angle, Turn)
  #local Low_ = min_extent(Object);
  #local High_ = max_extent(Object);
  // The box of what the object sweeps when it is turned about its middle.
  #local Reach_ = vlength((High_ - Low_)*<1, 0, 1>)/2;
  #local Middle_ = (Low_ + High_)/2;
  #local Swept_ = cylinder { <Middle_.x, Low_.y, Middle_.z>, <Middle_.x, High_.y, Middle_.z>, Reach_ }
  // The fit is that of the front, which is that of all sides.
  #local Distance_ = 1.05*FitDistance(Swept_, vrotate(-z, Elevation*x), Angle);
  camera {
    location Middle_ + Distance_*vrotate(vrotate(-z, Elevation*x), -360*Turn*y)
    look_at Middle_
    right x*image_width/image_height
    angle Angle
  }
#end

// PortraitCamera(Object, From, Angle, Blur)
// The object fills the picture and its nearest part is sharp; what is farther away goes soft.
// Blur: width of the lens as a share of the object's size: 0.02 subtle, 0.05 a portrait, 0.15 a model railway.
// Example: object { torus { 1, 0.3 } pigment { rgb 0.8 } } PortraitCamera(torus { 1, 0.3 }, <1, 1, -2>, 30, 0.05)
#macro PortraitCamera(Object, From, Angle, Blur)
  #local Distance_ = 1.1*FitDistance(Object, From, Angle);
  #local Low_ = min_extent(Object);
  #local Middle_ = (Low_ + max_extent(Object))/2;
  #local Size_ = vlength(max_extent(Object) - Low_);
  #local Eye_ = Middle_ + Distance_*Cameras_Isl_Back;
  #local Missed_ = <0, 0, 0>;
  #local Focus_ = trace(Object, Eye_, Middle_ - Eye_, Missed_);
  #if (vlength(Missed_) = 0)
    #local Focus_ = Middle_ + Size_/6*Cameras_Isl_Back;
  #end
  camera {
    location Eye_
    sky Cameras_Isl_Up
    look_at Middle_
    right x*image_width/image_height
    angle Angle
    aperture 2*Blur*Size_
    focal_point Focus_
    blur_samples 16
  }
#end

// PlanCamera(Object, From)
// Parallel rays, without perspective: plans, patterns and pictures to measure in.
// Example: object { torus { 1, 0.3 } pigment { rgb 0.8 } } PlanCamera(torus { 1, 0.3 }, y)
#macro PlanCamera(Object, From)
  #local Low_ = min_extent(Object);
  #local Half_ = (max_extent(Object) - Low_)/2;
  Cameras_Isl_Axes(From)
  #local Wide_ = 0;
  #for (I_, -1, 1, 2) #for (J_, -1, 1, 2) #for (K_, -1, 1, 2)
    #local Corner_ = Half_*<I_, J_, K_>;
    #local Wide_ = max(Wide_, 2.15*abs(vdot(Corner_, Cameras_Isl_Right)),
                       2.15*abs(vdot(Corner_, Cameras_Isl_Up))*image_width/image_height);
  #end #end #end
  camera {
    orthographic
    location Low_ + Half_ + 2*vlength(Half_)*Cameras_Isl_Back
    sky Cameras_Isl_Up
    look_at Low_ + Half_
    right Wide_*x
    up Wide_*image_height/image_width*y
  }
#end

#version Cameras_Isl_Before;
#end
