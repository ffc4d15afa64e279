sphere { 0 }
sphere { }
cylinder { 0, y }
camera { location }
