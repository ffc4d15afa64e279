sphere { <1, 2, 3>, 4 }
sphere { 0, -2 }
cylinder { 0, y, 0.5 open }
cone { 0, 1, y, 0 }
plane { <0, 2, 0>, 3 }
