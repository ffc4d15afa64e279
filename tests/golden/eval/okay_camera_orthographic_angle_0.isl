camera { orthographic right 4*x up 3*y location -5*z angle 0 look_at z }
