cone { 0, 1, y, 0 pigment { rgb x } finish { specualr 0.7 roughness 0.02 } }
