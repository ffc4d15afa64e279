// A texture is kept in the space of its object, before the object's own transform.
#declare P = pigment { gradient x }
sphere { 0, 1 pigment { P } translate 5*y }                        // goes along: the record is P's
sphere { 0, 1 translate 5*y pigment { P } }                        // stays: taken back by 5*y
sphere { 0, 1 scale 2 pigment { P } scale 3 pigment { rotate 90*z } translate x }
sphere { 0, 1 translate 5*y texture { uv_mapping pigment { P } } } // not in space at all
sphere { 0, 1 translate 5*y pigment { rgb 1 } }                    // nor is a plain colour
#declare Thing = sphere { 0, 1 pigment { P } rotate 90*y }
object { Thing translate x }
union { object { Thing scale 2 } sphere { 0, 1 } pigment { P } scale 4 }
blob { threshold 0.5
  sphere { 0, 1, 1 pigment { P } translate x }                     // in the blob's space: moved by x
  sphere { 0, 1, 1 translate x pigment { P } scale 2 }
  translate y }
