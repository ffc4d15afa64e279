// A `right` in the plane of up and direction shows no hand: turned to a point, the picture is mirrored.
camera { sky z up z right 4/3*x location <0, -10, 3> look_at 0 angle 50 }
