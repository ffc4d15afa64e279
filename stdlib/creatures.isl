// Parts of sea creatures, to be put together in a blob: crab, worm, starfish, jellyfish.
//
//   #include "creatures.isl"
//   blob { kernel "quartic" hardness 5 Creature_crab(0, 1, 8, seed(1)) }
//
// Parts are components of a blob of any kernel, a hardness of 4 to 6 keeps their form; in a union they are solids.
// Those that come close to one another and should not melt together stand in a `union` inside the blob.
#ifndef (Creatures_Isl_Before)
#declare Creatures_Isl_Before = version;
#version 3.7;
#include "math.inc"
#include "curves.isl"

// Creature_paint(Part)
// What every component has after its geometry: nothing. Declare a macro of this name after the include to paint by
// parts. The parameters of the macro that calls it are visible in it, so that names of yours like Radius, Size or
// Width mean those.
// Part: a string: "shell", "spine" (spines, teeth, knobs), "eye", "skin" (soft bodies), "rim".
// Example: #macro Creature_paint(P) pigment { rgb (P = "spine") } #end union { Creature_starfish(0, 1, 5, 12) }
#macro Creature_paint(Part) #end

// ---- Crabs ----------------------------------------------------------------------------------------------------------

// Creature_limb(A, RadiusA, B, RadiusB, Spines)
// One segment of a leg with its joint at the far end, and spines spread along it.
// A, B: its ends. RadiusA, RadiusB: its radii there. Spines: how many, usually 10, or 0.
// Example: blob { kernel "quartic" hardness 5 Creature_limb(-x, 0.3, x, 0.2, 30) pigment { rgb <0.8, 0.3, 0.2> } }
#macro Creature_limb(A, RadiusA, B, RadiusB, Spines)
  cone { A, RadiusA, B, RadiusB Creature_paint("shell") }
  sphere { B, RadiusB*1.08 Creature_paint("shell") }
  #local Creature_X = vnormalize(B - A);
  #local Creature_Side = VPerp_To_Vector(Creature_X);
  #for (Creature_I, 0, Spines - 1)
    #local Creature_T = (Creature_I + 0.5)/Spines;
    #local Creature_R = RadiusA + (RadiusB - RadiusA)*Creature_T;
    #local Creature_Out = vaxis_rotate(Creature_Side, Creature_X, 137.5*Creature_I);
    #local Creature_P = A + Creature_T*(B - A) + 0.85*Creature_R*Creature_Out;
    cone {
      Creature_P, 0.12*Creature_R, Creature_P + 0.6*Creature_R*Creature_Out + 0.2*Creature_R*Creature_X, 0.05*Creature_R
      Creature_paint("spine")
    }
  #end
#end

// Creature_leg(Hip, Knee, Ankle, Tip, Radius, Spines)
// A crab's walking leg: three segments, each thinner than the one before, the last one pointed.
// Hip, Knee, Ankle, Tip: its joints; the knee is the highest. Radius: at the hip. Spines: on each segment, usually 8.
// Example: blob { kernel "quartic" hardness 5 Creature_leg(-x, <-0.2, 0.6, 0>, <0.6, 0, 0>, <1, -0.8, 0>, 0.18, 8) }
#macro Creature_leg(Hip, Knee, Ankle, Tip, Radius, Spines)
  Creature_limb(Hip, Radius, Knee, 0.78*Radius, Spines)
  Creature_limb(Knee, 0.72*Radius, Ankle, 0.5*Radius, Spines)
  Creature_limb(Ankle, 0.48*Radius, Tip, 0.12*Radius, Spines)
#end

// Creature_claw(Shoulder, Elbow, Wrist, Size, Open)
// A crab's claw: two segments, the hand, and two fingers with teeth that go on from the wrist.
// Shoulder, Elbow, Wrist: its joints. Size: the hand's length with the fingers. Open: the angle between the fingers in
// degrees, 0 to 60, usually 25.
// Example: blob { kernel "quartic" hardness 5 Creature_claw(<-1, 0, 0.5>, <-0.8, 0, 0>, <-0.3, 0, 0>, 1, 30) }
#macro Creature_claw(Shoulder, Elbow, Wrist, Size, Open)
  #local Creature_R = 0.15*Size;
  Creature_limb(Shoulder, Creature_R, Elbow, 0.95*Creature_R, 6)
  Creature_limb(Elbow, 0.9*Creature_R, Wrist, 0.75*Creature_R, 6)
  // The hand is flat: it and its fingers lie in the plane of X and Z, where Z is as level as can be.
  #local Creature_X = vnormalize(Wrist - Elbow);
  #local Creature_Z = vcross(Creature_X, y);
  #if (vlength(Creature_Z) < 1e-3)
    #local Creature_Z = z;
  #end
  #local Creature_Z = vnormalize(Creature_Z);
  #local Creature_Palm = Wrist + 0.3*Size*Creature_X;
  cone {
    Wrist + 0.08*Size*Creature_X, 0.12*Size, Creature_Palm + 0.05*Size*Creature_Z, 0.16*Size
    Creature_paint("shell")
  }
  sphere { Creature_Palm - 0.1*Size*Creature_Z, 0.13*Size Creature_paint("shell") }
  #for (Creature_Side, -1, 1, 2)
    // Five cones, each turned towards the other finger.
    #local Creature_P = Creature_Palm + Creature_Side*0.11*Size*Creature_Z;
    #for (Creature_I, 0, 4)
      #local Creature_A = radians(Open*0.5 + 28 - 16*Creature_I);
      #local Creature_D = cos(Creature_A)*Creature_X + Creature_Side*sin(Creature_A)*Creature_Z;
      #local Creature_Q = Creature_P + Size*(0.15 - 0.01*Creature_I)*Creature_D;
      #local Creature_W = Size*(0.095 - 0.016*Creature_I)*(Creature_Side > 0 ? 1 : 0.85);
      cone { Creature_P, Creature_W, Creature_Q, Creature_W - 0.014*Size Creature_paint("shell") }
      #local Creature_In = -Creature_Side*(cos(Creature_A)*Creature_Z - Creature_Side*sin(Creature_A)*Creature_X);
      #for (Creature_J, 0, 2)
        sphere {
          Creature_P + (Creature_J + 0.5)/3*(Creature_Q - Creature_P) + 0.9*Creature_W*Creature_In, 0.02*Size
          Creature_paint("spine")
        }
      #end
      #local Creature_P = Creature_Q;
    #end
  #end
#end

// Creature_eye(Foot, Axis, Length, Radius)
// An eye on a stalk.
// Foot: where the stalk grows. Axis: its direction. Length: of the stalk. Radius: of the eye.
// Example: blob { kernel "quartic" hardness 6 sphere { -0.8*y, 0.6 } Creature_eye(-0.3*y, y, 0.7, 0.2) }
#macro Creature_eye(Foot, Axis, Length, Radius)
  #local Creature_X = vnormalize(Axis);
  cone { Foot, 0.75*Radius, Foot + Length*Creature_X, 0.5*Radius Creature_paint("shell") }
  sphere { Foot + (Length + 0.6*Radius)*Creature_X, Radius Creature_paint("eye") }
#end

// Creature_carapace(Centre, Width, Bumps, Stream)
// A crab's back shell, wider than long, its front towards -z: broad balls, a toothed rim, bumps.
// Centre: its middle. Width: from side to side. Bumps: how many, usually 150. Stream: a stream of `seed`.
// Example: blob { kernel "quartic" hardness 5 Creature_carapace(0, 2, 150, seed(1)) pigment { rgb <0.8, 0.3, 0.2> } }
#macro Creature_carapace(Centre, Width, Bumps, Stream)
  // Three rows of balls of less than the full strength make one broad, flat body.
  #for (Creature_I, -3, 3)
    #for (Creature_J, -1, 1)
      #local Creature_W = 1 - pow(abs(Creature_I)/3.6, 3) - 0.12*Creature_J*Creature_J;
      sphere {
        Centre + Width*(<0.115*Creature_I, 0, 0.02> + Creature_J*<0, -0.01*Creature_J, 0.13 - 0.0117*abs(Creature_I)>),
        Width*0.19*pow(Creature_W, 0.5) strength 0.4
        Creature_paint("shell")
      }
    #end
  #end
  #for (Creature_I, 0, 29)
    #local Creature_A = radians(12*Creature_I);
    #local Creature_P = Centre + Width*<0.455*cos(Creature_A), -0.02, 0.3*sin(Creature_A) + 0.02>;
    sphere { Creature_P, 0.03*Width Creature_paint("spine") }
  #end
  #for (Creature_I, 0, Bumps - 1)
    #local Creature_H = 1 - 0.8*(Creature_I + 0.5)/Bumps;
    #local Creature_D = vrotate(<sqrt(1 - Creature_H*Creature_H), Creature_H, 0>, 137.508*Creature_I*y);
    #local Creature_R = Width*(0.008 + 0.014*rand(Stream));
    sphere { Centre + Width*Creature_D*<0.44, 0.178, 0.29>, Creature_R Creature_paint("spine") }
  #end
#end

// Creature_crab(Centre, Width, Spines, Stream)
// A whole crab that looks towards -z; its feet stand 0.42 Width below the centre. For blobs.
// Centre: the middle of its back shell. Width: of that. Spines: on each segment of a leg, usually 8. Stream: a stream
// of `seed`.
// Example: blob { kernel "quartic" hardness 5 Creature_crab(0, 0.9, 6, seed(1)) pigment { rgb <0.8, 0.3, 0.2> } }
#macro Creature_crab(Centre, Width, Spines, Stream)
  Creature_carapace(Centre, Width, 150, Stream)
  #for (Creature_Mirror, -1, 1, 2)
    #for (Creature_K, 0, 3)
      #local Creature_Turn = <Creature_Mirror, 1, 1>*Width;
      #local Creature_To = vrotate(x, (-22 + 22*Creature_K + 6*rand(Stream))*-y);
      #local Creature_Lift = 0.04*rand(Stream);
      Creature_leg(Centre + Creature_Turn*(0.3*Creature_To - 0.06*y),
                   Centre + Creature_Turn*(0.66*Creature_To + (0.2 + Creature_Lift)*y),
                   Centre + Creature_Turn*(Creature_To - 0.04*y),
                   Centre + Creature_Turn*(1.18*Creature_To - 0.42*y), 0.075*Width, Spines)
    #end
    Creature_claw(Centre + Creature_Turn*<0.28, 0, -0.22>, Centre + Creature_Turn*<0.52, 0.1, -0.46>,
                  Centre + Creature_Turn*<0.4, 0.02, -0.72>, 0.62*Width, 25)
    Creature_eye(Centre + Creature_Turn*<0.1, 0.08, -0.26>, <0.25*Creature_Mirror, 1, -0.5>, 0.15*Width, 0.045*Width)
  #end
#end

// ---- Soft ones ------------------------------------------------------------------------------------------------------

// Creature_worm(Points, Segments)
// A worm or a caterpillar: balls along a curve, which show as its segments.
// Points: a curve with radii, as in curves.isl. Segments: how many; where they are about a radius apart, each shows.
// Example: blob { kernel "gaussian" Creature_worm(array[4] { -x + t/5, y/2 + t/4, -y/2 + t/4, x + t/9 }, 16) }
#macro Creature_worm(Points, Segments)
  #local Creature_Even = Curve_resample(Points, Segments - 1);
  #for (Creature_I, 0, Segments - 1)
    sphere { Curve_place(Creature_Even[Creature_I]), Creature_Even[Creature_I].t strength 0.8 Creature_paint("skin") }
  #end
#end

// Creature_starfish(Centre, Radius, Arms, Knobs)
// A starfish that lies flat across y, its arms tapered, with rows of knobs on its back.
// Centre: its middle. Radius: to the arms' tips. Arms: usually 5. Knobs: in each row, usually 12, or 0.
// Example: blob { kernel "gaussian" hardness 4 Creature_starfish(0, 1.2, 5, 12) pigment { rgb 1 } rotate -50*x }
#macro Creature_starfish(Centre, Radius, Arms, Knobs)
  #for (Creature_I, 0, Arms - 1)
    #local Creature_X = vrotate(x, 360*Creature_I/Arms*y);
    #local Creature_Z = vcross(Creature_X, y);
    #local Creature_Bend = 0.1*sin(2.4*Creature_I)*Radius*Creature_Z;
    #local Creature_P = Centre + 0.55*Radius*Creature_X + 0.4*Creature_Bend;
    cone { Centre, 0.15*Radius, Creature_P, 0.11*Radius Creature_paint("skin") }
    cone {
      Creature_P, 0.11*Radius, Centre + 0.95*Radius*Creature_X + Creature_Bend, 0.045*Radius
      Creature_paint("skin")
    }
    #for (Creature_J, 1, Knobs)
      #local Creature_T = Creature_J/(Knobs + 1);
      #local Creature_R = Radius*(0.17 - 0.12*Creature_T);
      #for (Creature_K, -1, 1)
        #local Creature_D = vaxis_rotate(y, Creature_X, 42*Creature_K);
        sphere {
          Centre + Radius*Creature_T*Creature_X + Creature_T*Creature_T*Creature_Bend + Creature_R*Creature_D,
          Radius*(0.026 - 0.012*Creature_T)*(Creature_K = 0 ? 1.3 : 1)
          Creature_paint("spine")
        }
      #end
    #end
  #end
#end

// Creature_bell(Centre, Radius, Height, Lobes)
// A jellyfish's bell: a thin dome of balls, open below, with a rim in lobes that turns in.
// Centre: the middle of its opening. Radius: of the opening. Height: of the dome. Lobes: of the rim, usually 16.
// Example: blob { kernel "gaussian" hardness 2 Creature_bell(-0.4*y, 0.8, 0.9, 16) pigment { rgb <0.7, 0.8, 1> } }
#macro Creature_bell(Centre, Radius, Height, Lobes)
  #for (Creature_I, 0, 18)
    #local Creature_A = 90 - 104*Creature_I/18;
    #local Creature_W = Radius*cos(radians(Creature_A));
    #local Creature_Y = Height*sin(radians(Creature_A));
    #local Creature_Count = max(1, ceil(2*pi*Creature_W/(0.1*Radius)));
    #for (Creature_J, 0, Creature_Count - 1)
      #local Creature_B = 360*(Creature_J + 0.5*mod(Creature_I, 2))/Creature_Count;
      #local Creature_Wave = 0.05*Radius*pow(Creature_I/18, 4)*abs(sin(radians(Creature_B*Lobes/2)));
      sphere {
        Centre + vrotate(<Creature_W + 0.5*Creature_Wave, Creature_Y - 1.5*Creature_Wave, 0>, Creature_B*y),
        0.085*Radius strength 0.4
        Creature_paint((Creature_I > 15 ? "rim" : "skin"))
      }
    #end
  #end
#end

// Creature_tentacle(Foot, Axis, Length, Radius, Sway, Stream)
// A curve for a tentacle or an arm that sways more and more towards its tip; for the limbs of curves.isl.
// Foot: where it grows. Axis: its direction. Length: along it. Radius: at its foot; a tenth of that at the tip. Sway:
// how far it wanders to the side, usually a fifth of Length. Stream: a stream of `seed`.
// Example: blob { kernel "gaussian" Curve_beads(Creature_tentacle(y, -y, 2, 0.12, 0.4, seed(2)), 4) pigment { rgb 1 } }
#macro Creature_tentacle(Foot, Axis, Length, Radius, Sway, Stream)
  #local Creature_Y = vnormalize(Axis);
  #local Creature_X = VPerp_To_Vector(Creature_Y);
  #local Creature_Z = vcross(Creature_X, Creature_Y);
  #local Creature_A = 2*pi*rand(Stream);
  #local Creature_B = 2*pi*rand(Stream);
  #local Creature_New = array[9];
  #for (Creature_I, 0, 8)
    #local Creature_T = Creature_I/8;
    #local Creature_S = Sway*pow(Creature_T, 0.8);
    #local Creature_P = Foot + Length*Creature_T*Creature_Y
      + Creature_S*(sin(Creature_A + 5*Creature_T) - sin(Creature_A))*0.6*Creature_X
      + Creature_S*(sin(Creature_B + 6*Creature_T) - sin(Creature_B))*0.6*Creature_Z;
    #local Creature_New[Creature_I] = <Creature_P.x, Creature_P.y, Creature_P.z, Radius*(1 - 0.9*Creature_T)>;
  #end
  Creature_New
#end

#version Creatures_Isl_Before;
#end
