camera { orthographic right 4*x up 3*y location -5*z look_at 0 scale 2 }
