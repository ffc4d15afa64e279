// Maps without entries, with entries out of order or without their colours. Order is POV-Ray's: no mistake.
sphere { 0, 1 pigment { gradient x color_map { } } }
sphere { 0, 1 pigment { gradient x pigment_map { } } }
sphere { 0, 1 texture { gradient x texture_map { } } }
sphere { 0, 1 normal { gradient x normal_map { } } }
sphere { 0, 1 normal { gradient x slope_map { } } }
sphere { 0, 1 pigment { gradient x color_map { [0.5 rgb 1] [0.2 rgb 0] [0.9 rgb 0.3] } } }
sphere { 0, 1 pigment { gradient x color_map { [0.5] } } }
sphere { 0, 1 pigment { gradient x color_map { 0.5 rgb 1 } } }
sphere { 0, 1 pigment { average pigment_map { [0 rgb 1] [0 rgb 0] } } }
