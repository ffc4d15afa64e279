camera { angle 180 }
camera { look_at 0 }
camera { right 0 look_at z }
camera { cylinder 5 }
camera { aperture .4 blur_samples 10, 3 }
camera { aperture .4 blur_samples 0 }
camera { fisheye angle -1 }
camera { locaton x }
camera { mesh_camera { 1 0 } }
