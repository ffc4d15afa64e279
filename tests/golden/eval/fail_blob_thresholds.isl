blob { threshold 1/0 sphere { 0, 1, 1 } }
blob { threshold -1 union { sphere { 0, 1, 1 } sphere { x, 1, 1 } } }
