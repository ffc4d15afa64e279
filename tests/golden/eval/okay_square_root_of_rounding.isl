// Only rounding makes these negative.
#declare A = 0.1 + 0.2;
#declare V = vnormalize(<1, 1, 1>)*(1 + 1e-15);
#debug concat(str(sqrt(0.3 - A), 0, 3), " ", str(sqrt(1 - V.x*V.x - V.y*V.y - V.z*V.z), 0, 3), " ",
              str(sqrt(2*(0.3 - A)/3), 0, 3), "\n")
