camera { angle 180 }
camera { look_at 0 }
camera { right 0 look_at z }
