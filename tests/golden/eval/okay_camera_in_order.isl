// Before 3.5 each item works on what stands before it: the angle is that of the old `right`, and `up` is not turned.
#version 3.1;
camera { angle 40 right -1.5*x look_at <1, 2, 3> up z }
