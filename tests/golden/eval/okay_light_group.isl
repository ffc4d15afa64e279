light_group {
  light_source { y, rgb 1 spotlight point_at 0 }
  sphere { 0, 1 }
  union { sphere { x, 1 } light_source { 2*y, rgb 1 } translate z }
  translate x
}
#declare Stage = light_group { light_source { 0, rgb x } sphere { 0, 2 } global_lights on }
light_group { Stage scale 2 }
union { sphere { 0, 3 } Stage }
