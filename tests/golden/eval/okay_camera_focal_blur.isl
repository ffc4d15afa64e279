// The distance that is sharp is that of before the transforms.
camera {
  location -10*z aperture .4 focal_point x blur_samples 4, 50 confidence .95 variance 1/256 confidence 2
  bokeh { pigment { rgb <1, .5, 0> } } normal { bumps .3 } scale 2
}
