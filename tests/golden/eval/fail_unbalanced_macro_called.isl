// A library may define a macro whose body pastes half a block; it is an error where it is called.
#macro Open(C)
  #if (C) union { sphere { 0, 1 } #else sphere { 0, 1 #end
#end
Open(1)
#debug "still read\n"
