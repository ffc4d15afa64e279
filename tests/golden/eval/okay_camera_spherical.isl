camera { spherical angle 300, 100 look_at x }
