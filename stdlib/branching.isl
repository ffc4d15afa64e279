// Trees, corals and all that branches: as components of a blob of any kernel (tapered cones) and as solids in a union.
//
//   #include "branching.isl"
//   blob { kernel "gaussian" hardness 3 Branch_tree(-y, y, 0.9, 0.15, 6, 0.2, seed(1)) }
//
// Thickness follows the pipe model (Shinozaki and others 1964; Leonardo's rule): a limb carries one pipe for each tip
// above it, so that its radius to the power of Branch_Exponent is the sum of those of what grows from it.
#ifndef (Branching_Isl_Before)
#declare Branching_Isl_Before = version;
#version 3.7;
#include "math.inc"

// Branch_Exponent: number. The exponent of the pipe model: 2 keeps the area of the cross-sections, greater ones make
// stems thinner; 2.3 suits most trees.
#declare Branch_Exponent = 2.3;

// ---- What branches are made of --------------------------------------------------------------------------------------

// Branch_paint(Level, Share)
// What every limb has after its geometry: nothing. Declare a macro of this name after the include to paint; in a blob
// it may begin with a `strength`. The parameters of the macro that calls it are visible in it, so that names of yours
// like Foot, Tip, Length or Radius mean those.
// Level: the number of forks below the limb, from 0. Share: the same as a share of all levels, 0 at the foot to 1 at
// the tips.
// Example: #macro Branch_paint(L, S) pigment { rgb S } #end union { Branch_tree(-y, y, 0.6, 0.1, 6, 0, seed(1)) }
#macro Branch_paint(Level, Share) #end

// Branch_limb(A, RadiusA, B, RadiusB, Level, Share)
// What stands between two forks: a cone. Declare a macro of this name after the include to have something else there.
// A, B: its ends. RadiusA, RadiusB: its radii there. Level, Share: as those of Branch_paint.
// Example: #macro Branch_limb(A,R, B,S, L,T) sphere { B, S } #end union { Branch_tree(-y, y, 1, 0.2, 6, 0, seed(1)) }
#macro Branch_limb(A, RadiusA, B, RadiusB, Level, Share)
  cone { A, RadiusA, B, RadiusB Branch_paint(Level, Share) }
#end

// Branch_tip(Place, Axis, Radius)
// What stands at the end of every last limb: nothing. Declare a macro of this name after the include to have leaves,
// needles or polyps there.
// Place: the end. Axis: the limb's direction, of length 1. Radius: the limb's radius there.
// Example: #macro Branch_tip(P, A, R) sphere { P, 3*R } #end union { Branch_tree(-y, y, 0.6, 0.1, 6, 0.2, seed(1)) }
#macro Branch_tip(Place, Axis, Radius) #end

// Branch_pipe(Tip, Tips)
// The radius of a limb by the pipe model.
// Tip: the radius of a tip. Tips: the number of tips that it carries.
// Example: #for (I, 0, 5) sphere { (I/2.5 - 1)*x, Branch_pipe(0.04, pow(2, I)) pigment { rgb 1 } } #end
#macro Branch_pipe(Tip, Tips) (Tip*pow(Tips, 1/Branch_Exponent)) #end

// ---- Trees that fork ------------------------------------------------------------------------------------------------

// Branch_tree(Foot, Axis, Length, Radius, Depth, Jitter, Stream)
// A tree whose limbs fork in two, with the angles and shares of the tree in E. Haines' Standard Procedural Databases
// (1987): 40 and 25 degrees, 0.65 and 0.70 of the length.
// Foot: where the stem begins. Axis: where it points. Length: of the stem; the tree is about three times as high.
// Radius: of the stem's foot. Depth: forks on the way to a tip, so that there are 2^Depth tips, usually 6 to 10.
// Jitter: 0 (regular) to 1 (wild), usually 0.3. Stream: a stream of `seed`.
// Example: blob { kernel "gaussian" hardness 3 Branch_tree(-y, y, 0.7, 0.14, 6, 0.3, seed(4)) }
#macro Branch_tree(Foot, Axis, Length, Radius, Depth, Jitter, Stream)
  #local Branch_Thin = Radius/Branch_pipe(1, pow(2, Depth));
  Branch_fork(Foot, vnormalize(Axis), VPerp_To_Vector(Axis), Length, Branch_Thin, Depth, 0, Jitter, Stream)
#end

// Branch_fork(Foot, Axis, Side, Length, Tip, Depth, Level, Jitter, Stream)
// A limb of such a tree and all that grows from it; what Branch_tree is made of.
// Axis, Side: two directions of length 1 at right angles. Tip: the radius at the tips. Level: 0 for a stem. The
// others: as those of Branch_tree.
// Example: union { Branch_fork(-y, y, x, 0.7, 0.02, 5, 0, 0.2, seed(2)) pigment { rgb 1 } }
#macro Branch_fork(Foot, Axis, Side, Length, Tip, Depth, Level, Jitter, Stream)
  #local Branch_End = Foot + Length*(1 + Jitter*(rand(Stream) - 0.5))*Axis;
  #local Branch_R = Branch_pipe(Tip, pow(2, Depth - Level));
  #local Branch_S = (Level < Depth ? Branch_pipe(Tip, pow(2, Depth - Level - 1)) : Tip*0.6);
  Branch_limb(Foot, Branch_R, Branch_End, Branch_S, Level, Level/max(Depth, 1))
  #if (Level < Depth)
    #for (Branch_J, 0, 1)
      #local Branch_Turn = (Branch_J = 0 ? 90 : 230) + 120*Jitter*(rand(Stream) - 0.5);
      #local Branch_Bend = (Branch_J = 0 ? 40 : 25)*(1 + Jitter*(rand(Stream) - 0.5));
      #local Branch_X = vaxis_rotate(Side, Axis, Branch_Turn);
      #local Branch_Y = vaxis_rotate(Axis, vcross(Branch_X, Axis), -Branch_Bend);
      Branch_fork(Branch_End, Branch_Y, vaxis_rotate(Branch_X, vcross(Branch_X, Axis), -Branch_Bend),
                  Length*(Branch_J = 0 ? 0.65 : 0.70), Tip, Depth, Level + 1, Jitter, Stream)
    #end
  #else
    Branch_tip(Branch_End, Axis, Branch_S)
  #end
#end

// Branch_thorns(Place, Axis, Count, Length, Radius)
// Thin cones all round a place, evenly spread over a little more than half a sphere: the needles at a coral's tips.
// Place: where they grow. Axis: the middle one's direction. Count: how many, usually 12 to 32. Length: of each.
// Radius: at its foot.
// Example: blob { kernel "gaussian" sphere { 0, 0.2 } Branch_thorns(0, y, 32, 0.8, 0.06) pigment { rgb 1 } }
#macro Branch_thorns(Place, Axis, Count, Length, Radius)
  #local Branch_Y = vnormalize(Axis);
  #local Branch_X = VPerp_To_Vector(Branch_Y);
  #local Branch_Z = vcross(Branch_X, Branch_Y);
  #for (Branch_J, 0, Count - 1)
    #local Branch_H = 1 - 1.35*(Branch_J + 0.5)/Count;
    #local Branch_A = pi*(3 - sqrt(5))*Branch_J;
    #local Branch_W = sqrt(1 - Branch_H*Branch_H);
    #local Branch_D = Branch_H*Branch_Y + Branch_W*(cos(Branch_A)*Branch_X + sin(Branch_A)*Branch_Z);
    cone { Place, Radius, Place + Length*Branch_D, Radius*0.3 Branch_paint(0, 1) }
  #end
#end

// Branch_coral(Foot, Axis, Length, Radius, Depth, Thorns, Jitter, Stream)
// A coral: a forked tree with needles at its tips, as Branch_thorns makes them.
// Thorns: needles at each tip, usually 24. The others: as those of Branch_tree; Depth is usually 4.
// Example: blob { kernel "gaussian" hardness 3 Branch_coral(-y, y, 0.7, 0.16, 4, 24, 0.2, seed(3)) }
#macro Branch_coral(Foot, Axis, Length, Radius, Depth, Thorns, Jitter, Stream)
  Branch_coral_fork(Foot, vnormalize(Axis), VPerp_To_Vector(Axis), Length, Radius, Depth, 0, Thorns, Jitter, Stream)
#end

// Branch_coral_fork(Foot, Axis, Side, Length, Radius, Depth, Level, Thorns, Jitter, Stream)
// A limb of a coral and all that grows from it; what Branch_coral is made of. Its limbs thin out by a third a fork, as
// coral does.
// Axis, Side: two directions of length 1 at right angles. Level: 0 for a stem. The others: as those of Branch_coral.
// Example: union { Branch_coral_fork(-y, y, x, 0.7, 0.1, 3, 0, 20, 0.2, seed(2)) pigment { rgb 1 } }
#macro Branch_coral_fork(Foot, Axis, Side, Length, Radius, Depth, Level, Thorns, Jitter, Stream)
  #local Branch_End = Foot + Length*(1 + Jitter*(rand(Stream) - 0.5))*Axis;
  Branch_limb(Foot, Radius, Branch_End, Radius*0.67, Level, Level/max(Depth, 1))
  #if (Level < Depth)
    #for (Branch_J, 0, 1)
      #local Branch_Turn = (Branch_J = 0 ? 90 : 230) + 120*Jitter*(rand(Stream) - 0.5);
      #local Branch_Bend = (Branch_J = 0 ? 40 : 25)*(1 + Jitter*(rand(Stream) - 0.5));
      #local Branch_X = vaxis_rotate(Side, Axis, Branch_Turn);
      #local Branch_Y = vaxis_rotate(Axis, vcross(Branch_X, Axis), -Branch_Bend);
      Branch_coral_fork(Branch_End, Branch_Y, vaxis_rotate(Branch_X, vcross(Branch_X, Axis), -Branch_Bend),
                        Length*(Branch_J = 0 ? 0.65 : 0.70), Radius*0.67, Depth, Level + 1, Thorns, Jitter, Stream)
    #end
  #else
    Branch_thorns(Branch_End, Axis, Thorns, Length*0.85, Radius*0.42)
  #end
#end

// Branch_filling(Low, High, Foot, Tip, Depth, Jitter, Stream)
// A tree that fills a box: at each fork the space that is left is halved across its longest side, and a limb goes to
// the middle of each half. So veins, bronchi and gorgonian fans fill their space.
// Low, High: corners of the box; a flat box makes a fan. Foot: where the stem begins, usually in the middle of a side.
// Tip: the tips' radius; the stem's is that of Branch_pipe. Depth: halvings, so that there are 2^Depth tips, usually 8
// to 12. Jitter: 0 to 0.5, how far from the middle the box is cut, usually 0.2. Stream: a stream of `seed`.
// Example: union { Branch_filling(<-1, -1, -0.2>, <1, 1, 0.2>, -y, 0.01, 9, 0.2, seed(1)) }
#macro Branch_filling(Low, High, Foot, Tip, Depth, Jitter, Stream)
  Branch_halve(Low, High, Foot, (High - Low)*y, Tip, Depth, 0, Jitter, Stream)
#end

// Branch_halve(Low, High, Foot, Axis, Tip, Depth, Level, Jitter, Stream)
// A limb of such a tree and all that grows from it; what Branch_filling is made of.
// Axis: the direction of the limb below. Level: 0 for a stem. The others: as those of Branch_filling.
// Example: union { Branch_halve(<-1, -1, -1>, 1, -y, y, 0.02, 8, 0, 0.2, seed(1)) pigment { rgb 1 } }
#macro Branch_halve(Low, High, Foot, Axis, Tip, Depth, Level, Jitter, Stream)
  #local Branch_Size = High - Low;
  #local Branch_End = (Low + High)/2 - 0.3*(Low + High - 2*Foot)/2;
  #local Branch_R = Branch_pipe(Tip, pow(2, Depth - Level));
  #local Branch_S = (Level < Depth ? Branch_pipe(Tip, pow(2, Depth - Level - 1)) : Tip*0.6);
  Branch_limb(Foot, Branch_R, Branch_End, Branch_S, Level, Level/max(Depth, 1))
  #if (Level < Depth)
    #local Branch_Cut = 0.5 + Jitter*(rand(Stream) - 0.5);
    #local Branch_Way = x;
    #if (Branch_Size.y > Branch_Size.x)
      #local Branch_Way = y;
    #end
    #if (Branch_Size.z > max(Branch_Size.x, Branch_Size.y))
      #local Branch_Way = z;
    #end
    #local Branch_Step = Branch_Way*Branch_Size*Branch_Cut;
    #local Branch_Top = High - Branch_Way*Branch_Size + Branch_Step;
    Branch_halve(Low, Branch_Top, Branch_End, Axis, Tip, Depth, Level + 1, Jitter, Stream)
    Branch_halve(Low + Branch_Step, High, Branch_End, Axis, Tip, Depth, Level + 1, Jitter, Stream)
  #else
    Branch_tip(Branch_End, vnormalize(Branch_End - Foot), Branch_S)
  #end
#end

// ---- Turtles and L-systems ------------------------------------------------------------------------------------------

// Branch_turtle(Text, Foot, Axis, Step, Angle, Tip, Jitter, Stream)
// Draws a string as a turtle in space walks it (Prusinkiewicz and Lindenmayer 1990). F goes a step and leaves a limb,
// f goes without; + and - turn left and right, & and ^ down and up, / and \ roll, all by Angle; | turns back; [
// remembers the place and ] returns to it; > and < make steps shorter and longer by a tenth. Other letters do nothing.
// Limbs are as thick as the pipe model makes them.
// Text: the string. Foot, Axis: where the turtle begins and looks. Step: its length. Angle: in degrees, usually 20 to
// 30. Tip: the tips' radius. Jitter: 0 to 1, usually 0.2. Stream: a stream of `seed`.
// Example: union { Branch_turtle("FF[+F[-F]F]F[-FF]F", -y, y, 0.3, 30, 0.04, 0.1, seed(1)) pigment { rgb 1 } }
#macro Branch_turtle(Text, Foot, Axis, Step, Angle, Tip, Jitter, Stream)
  Branch_lsystem(Text, array[1][2] {{"", ""}}, 0, Foot, Axis, Step, Angle, Tip, Jitter, Stream)
#end

// Branch_lsystem(Axiom, Rules, Depth, Foot, Axis, Step, Angle, Tip, Jitter, Stream)
// Draws an L-system: a string in which letters are replaced by strings, again and again, as Branch_turtle draws it.
// The grown string is never made, so that a hundred thousand letters take a moment.
// Axiom: the string to begin with. Rules: array[N][2] of letters and what replaces them. Depth: how often, usually 3
// to 6. The others: as those of Branch_turtle.
// Example: union { Branch_lsystem("F", array[1][2] {{"F", "F[+F]F[-/F]"}}, 4, -y, y, 0.06, 25, 0.01, 0.2, seed(1)) }
#macro Branch_lsystem(Axiom, Rules, Depth, Foot, Axis, Step, Angle, Tip, Jitter, Stream)
  // Two walks: the first counts limbs and brackets, the second keeps the limbs.
  #local Branch_Rule = array[128];
  #for (J, 0, dimension_size(Rules, 1) - 1)
    #if (strlen(Rules[J][0]) > 0)
      #local Branch_Rule[asc(Rules[J][0])] = Rules[J][1];
    #end
  #end
  #local Branch_Limbs = 0;
  #local Branch_Open = 0;
  #local Branch_Most = 0;
  Branching_Isl_count(Axiom, Depth)
  #local Branch_A = array[Branch_Limbs + 1];
  #local Branch_B = array[Branch_Limbs + 1];
  #local Branch_Below = array[Branch_Limbs + 1];
  #local Branch_Forks = array[Branch_Limbs + 1];
  #local Branch_Pipes = array[Branch_Limbs + 1];
  #local Branch_Last = array[Branch_Limbs + 1];
  // The turtle: place, heading, left, the limb it stands on, step; the same for each of the brackets around it.
  #local Branch_P = <0, 0, 0> + Foot;
  #local Branch_H = vnormalize(Axis);
  #local Branch_L = VPerp_To_Vector(Branch_H);
  #local Branch_On = 0;
  #local Branch_Length = Step;
  #local Branch_Stack = array[Branch_Most + 1][5];
  #local Branch_Limbs = 0;
  #local Branch_Open = 0;
  Branching_Isl_walk(Axiom, Depth)
  #for (J, 0, Branch_Limbs)
    #local Branch_Pipes[J] = 0;
    #local Branch_Last[J] = no;
  #end
  #local Branch_Deepest = 1;
  #for (J, Branch_Limbs, 1, -1)
    #if (Branch_Pipes[J] = 0)
      #local Branch_Pipes[J] = 1;
      #local Branch_Last[J] = yes;
    #end
    #local Branch_Deepest = max(Branch_Deepest, Branch_Forks[J]);
    #local Branch_Pipes[Branch_Below[J]] = Branch_Pipes[Branch_Below[J]] + Branch_Pipes[J];
  #end
  #for (J, 1, Branch_Limbs)
    #local Branch_R = Branch_pipe(Tip, Branch_Pipes[J]);
    #local Branch_Q = Branch_R;
    #if (Branch_Below[J] > 0)
      #local Branch_Q = min(Branch_pipe(Tip, Branch_Pipes[Branch_Below[J]]), 1.3*Branch_R);
    #end
    Branch_limb(Branch_A[J], Branch_Q, Branch_B[J], Branch_R, Branch_Forks[J], Branch_Forks[J]/Branch_Deepest)
    #if (Branch_Last[J])
      Branch_tip(Branch_B[J], vnormalize(Branch_B[J] - Branch_A[J]), Branch_R)
    #end
  #end
#end

// Branching_Isl_count(Text, Depth)
// Counts limbs and open brackets of an L-system; a part of Branch_lsystem, in which alone it works.
// Text: the string. Depth: replacements that are still to come.
// Example: union { Branch_lsystem("F[+F]F", array[1][2] {{"F", "F[+F]F"}}, 2, -y, y, 0.2, 30, 0.02, 0, seed(1)) }
#macro Branching_Isl_count(Text, Depth)
  #for (Branch_I, 1, strlen(Text))
    #local Branch_C = asc(substr(Text, Branch_I, 1));
    #if (Depth > 0 & defined(Branch_Rule[Branch_C]))
      Branching_Isl_count(Branch_Rule[Branch_C], Depth - 1)
    #else
      #switch (Branch_C)
        #case (70)
          #declare Branch_Limbs = Branch_Limbs + 1;
        #break
        #case (91)
          #declare Branch_Open = Branch_Open + 1;
          #declare Branch_Most = max(Branch_Most, Branch_Open);
        #break
        #case (93)
          #declare Branch_Open = Branch_Open - 1;
        #break
      #end
    #end
  #end
#end

// Branching_Isl_walk(Text, Depth)
// Walks an L-system; a part of Branch_lsystem, in which alone it works.
// Text: the string. Depth: replacements that are still to come.
// Example: union { Branch_lsystem("F", array[1][2] {{"F", "F[+F]F[-F]F"}}, 3, -y, y, 0.08, 25, 0.01, 0, seed(1)) }
#macro Branching_Isl_walk(Text, Depth)
  #for (Branch_I, 1, strlen(Text))
    #local Branch_C = asc(substr(Text, Branch_I, 1));
    #if (Depth > 0 & defined(Branch_Rule[Branch_C]))
      Branching_Isl_walk(Branch_Rule[Branch_C], Depth - 1)
    #else
      #switch (Branch_C)
        #case (70)   // F
          #declare Branch_Limbs = Branch_Limbs + 1;
          #declare Branch_A[Branch_Limbs] = Branch_P;
          #declare Branch_P = Branch_P + Branch_Length*Branch_H;
          #declare Branch_B[Branch_Limbs] = Branch_P;
          #declare Branch_Below[Branch_Limbs] = Branch_On;
          #declare Branch_Forks[Branch_Limbs] = Branch_Open;
          #declare Branch_On = Branch_Limbs;
        #break
        #case (102)  // f
          #declare Branch_P = Branch_P + Branch_Length*Branch_H;
        #break
        #case (43)   // +
          Branching_Isl_turn(vcross(Branch_H, Branch_L), 1)
        #break
        #case (45)   // -
          Branching_Isl_turn(vcross(Branch_H, Branch_L), -1)
        #break
        #case (38)   // &
          Branching_Isl_turn(Branch_L, 1)
        #break
        #case (94)   // ^
          Branching_Isl_turn(Branch_L, -1)
        #break
        #case (47)   // /
          Branching_Isl_turn(Branch_H, 1)
        #break
        #case (92)   // \
          Branching_Isl_turn(Branch_H, -1)
        #break
        #case (124)  // |
          #declare Branch_H = -Branch_H;
          #declare Branch_L = -Branch_L;
        #break
        #case (62)   // >
          #declare Branch_Length = Branch_Length*0.9;
        #break
        #case (60)   // <
          #declare Branch_Length = Branch_Length/0.9;
        #break
        #case (91)   // [
          #declare Branch_Stack[Branch_Open][0] = Branch_P;
          #declare Branch_Stack[Branch_Open][1] = Branch_H;
          #declare Branch_Stack[Branch_Open][2] = Branch_L;
          #declare Branch_Stack[Branch_Open][3] = Branch_On;
          #declare Branch_Stack[Branch_Open][4] = Branch_Length;
          #declare Branch_Open = Branch_Open + 1;
        #break
        #case (93)   // ]
          #declare Branch_Open = Branch_Open - 1;
          #declare Branch_P = Branch_Stack[Branch_Open][0];
          #declare Branch_H = Branch_Stack[Branch_Open][1];
          #declare Branch_L = Branch_Stack[Branch_Open][2];
          #declare Branch_On = Branch_Stack[Branch_Open][3];
          #declare Branch_Length = Branch_Stack[Branch_Open][4];
        #break
      #end
    #end
  #end
#end

// Branching_Isl_turn(About, Sign)
// Turns the turtle; a part of Branch_lsystem, in which alone it works.
// About: the axis. Sign: 1 or -1.
// Example: union { Branch_turtle("F+F+F+F+F", -x, y, 0.8, 72, 0.05, 0, seed(1)) pigment { rgb 1 } }
#macro Branching_Isl_turn(About, Sign)
  #local Branch_Axis = About;
  #local Branch_By = Sign*Angle*(1 + Jitter*(2*rand(Stream) - 1));
  #declare Branch_H = vaxis_rotate(Branch_H, Branch_Axis, Branch_By);
  #declare Branch_L = vaxis_rotate(Branch_L, Branch_Axis, Branch_By);
#end

#version Branching_Isl_Before;
#end
