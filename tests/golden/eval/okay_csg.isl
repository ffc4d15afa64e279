intersection { sphere { 0, 1 } box { 0, 2 } cutaway_textures pigment { rgb x } }
difference { box { -1, 1 } sphere { 0, 1.2 } cylinder { -2*y, 2*y, .5 } rotate 45*y }
merge { sphere { 0, 1 } sphere { x, 1 } split_union off }
union { sphere { 0, 1 } plane { y, 0 } split_union on }
#declare Cut = difference { sphere { 0, 2 } sphere { y, 1 } }
// A name at the start stands for the whole, whatever the word; the group is shared.
union { Cut translate x }
object { Cut cutaway_textures }
difference { sphere { 0, 5 } Cut inverse }
// Few children, light among them, and an intersection with what has no inside.
union { sphere { 0, 9 } }
merge { }
difference { sphere { 0, 10 } }
union { light_source { 0, 1 } sphere { 0, 8 } translate z }
intersection { triangle { 0, x, y } sphere { 0, 7 } }
