camera { aperture .4 focal_point z angle 0 }
