// A focal point beside the camera is at no distance that could be sharp.
camera { aperture .4 focal_point x blur_samples 10 angle 0 }
