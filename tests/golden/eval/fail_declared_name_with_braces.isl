#declare Ball = sphere { 0, 1 }
#declare Skin = texture { pigment { rgb 1 } }
#declare Number = 3;
Ball { translate x }
object { Ball Skin { scale 2 } }
union { Number { 0, 1 } }
