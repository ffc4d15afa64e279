#declare A = rgb <1, 0, 0>;
#declare B = color red 1 green 0.5 filter 0.2;
#declare C = White transmit 0.5;
#declare D = rgb A.red;
pigment { color A transmit 0.5 }
