#version 3.8;
#declare A = pigment { gradient x color_map { blend_mode 5 [0 rgb 1] [1 rgb 0] } }
#declare B = pigment { gradient x color_map { blend_mode 2 blend_gamma 0 [0 rgb 1] [1 rgb 0] } }
#declare C = pigment { gradient x pigment_map { blend_mode 2 [0 checker] [1 rgb 0] } }
#declare D = pigment { gradient x color_map { [0 rgb 1] blend_mode 2 [1 rgb 0] } }
