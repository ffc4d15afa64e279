fog { distance 10 fog_type 3 }
fog { distance 10 <1, 0, 0> }
rainbow { angle 40 }
rainbow { direction z up z }
rainbow { direction z arc_angle 400 }
rainbow { direction z arc_angle 100 falloff_angle 120 }
sky_sphere { }
sky_sphere { texture { pigment { rgb 1 } } }
#declare F = fog { distance 3 }
rainbow { F }
F
