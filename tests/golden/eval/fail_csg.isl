#declare Pair = union { sphere { 0, 1 } sphere { x, 1 } }
union { Pair sphere { 0, 1 } }
union { sphere { 0, 1 } sphere { x, 1 } cutaway_textures }
sphere { 0, 1 cutaway_textures }
object { sphere { 0, 1 } sphere { 0, 1 } }
object { }
intersection { sphere { 0, 1 } pigment { rgb 1 } box { 0, 1 } }
light_group { light_source { 0, 1 } global_lights on sphere { 0, 1 } }
light_group { light_source { 0, 1 } pigment { rgb 1 } }
difference { 1 }
