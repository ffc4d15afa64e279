camera { location x }
camera { panoramic angle 120 }
camera { fisheye look_at x }
