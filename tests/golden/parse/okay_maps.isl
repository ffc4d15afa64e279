color_map { [0 rgb 0] [0.5, 1.0 color Red color Blue] }
