sphere { 0, 0 }
blob { sphere { 0, -1, 1 } }
blob { sphere { 0, 1/0, 1 } }
blob { cylinder { x, x, 1, 1 } }
blob { threshold 0 sphere { 0, 1, 1 } }
cone { 0, 0, y, 0 }
plane { 0, 1 }
