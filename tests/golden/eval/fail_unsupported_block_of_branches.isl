// The items of an unsupported block are skipped, wherever its braces stand.
#macro Part(Open)
  #if (Open) mesh2 { vertex_vectors { 3, #else union { object { #end
    0, x, y
  #if (Open) } face_indices { 1, <0, 1, 2> } } #else } } #end
#end
object { Part(1) translate x }
sphere { 0, 1 }
