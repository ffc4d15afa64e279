box { -1, 1 }
sphere { 0, 1 pigment { marble } }
sphere { 0, 1 interior { ior 1.5 } }
