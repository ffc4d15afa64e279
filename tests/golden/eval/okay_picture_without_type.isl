// A name without type and extension is that of a .png file.
sphere { 0, 1 pigment { image_map { "a" } } }
