#macro Strut(From, To, Radius)
  cylinder { From, To, Radius }
#end
union {
  Strut(0, <1, 2, 1>)
  pigment { rgb 1 }
}
