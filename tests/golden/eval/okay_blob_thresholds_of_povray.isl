// The fields end where their sum is 0: the surface of the threshold 0 lies just before.
blob { threshold 0 sphere { 0, 1.5, 2 } sphere { x, 1.5, -1 } }
// Below 0, the far away is inside: signs change, and the inside.
blob { threshold -0.3 sphere { 0, 2, -1 } sphere { x, 1.5, 1 } }
blob { threshold -0.3 sphere { 0, 2, -1 } inverse }
// The last threshold counts.
blob { threshold -1 threshold 0.5 sphere { 0, 2, 1 } }
// A part keeps the surface that it has alone.
blob { threshold 0.6 sphere { 0, 1, 1 } blob { threshold -0.3 sphere { x, 1, -1 } } }
