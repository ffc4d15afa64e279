// Cameras that have the words of a blur and none, or another focus than they seem to have.
camera { aperture .4 focal_point 0 blur_samples 10 angle 0 }
camera { aperture 0 focal_point z blur_samples 10 }
camera { location -3*z aperture .1 focal_point <0, 4, -3> blur_samples 10 }
camera { location -3*z aperture .1 focal_point -5*z blur_samples 10 }
