sphere { 0, 1/0 }
blob { sphere { 0, -1, 1 } }
blob { sphere { 0, 1/0, 1 } }
blob { cylinder { x, x, 1, 1 } }
blob { threshold 0 sphere { 0, 1, 1 } }
torus { 1/0, 1 }
plane { 0, 1 }
