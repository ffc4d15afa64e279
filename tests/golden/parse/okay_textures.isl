#declare Skin = texture { pigment { rgb 1 } } texture { finish { phong 1 } }
sphere { 0, 1 texture { Skin } }
