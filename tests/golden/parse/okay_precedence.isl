#declare A = 1 + 2 * -3 - 4 / 5;
#declare B = -V.y * 2;
#declare C = (1 | 0 & 0);
#declare D = (1 + 2 < 3 = 0);
#declare E = (A > 1 ? B : C ? 2 : 3);
#declare F = !A + B;
