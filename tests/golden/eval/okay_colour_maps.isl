#declare Red = rgb <1, 0, 0>;
#declare Half = 0.5;
#declare Map = color_map { [0 Red] [Half, Red filter 0.3] [1.0 color red 0.2 green 0.4] }
#macro Entries(N) #for (I, 1, N) [I/10 rgb I/10] #end #end
sphere { 0, 1 pigment { onion color_map { Map } } }
sphere { 0, 1 pigment { granite colour_map { Map } } }
sphere { 0, 1 pigment { gradient x color_map { [0.0 0.4 color Red color rgb 1] [0.4, 0.9 color Red, color Red transmit 1] } } }
sphere { 0, 1 pigment { gradient y color_map { Entries(3) #if (Half > 1) [0.4 rgb 9] #else [0.5 rgbft <1, 2, 3, 4, 5>] #end
  #declare Last = 1; [Last rgb 0] } } }
sphere { 0, 1 pigment { gradient z color_map { [0.6 rgb 1] } } }
#declare Pigments = pigment_map { [0 Red] [0.5 color rgb 1 filter 0.1] [1 checker Red, rgb 0 scale 2] }
sphere { 0, 1 pigment { marble pigment_map { Pigments } } }
sphere { 0, 1 pigment { marble pigment_map { [0 rgb 1] [1 wood pigment_map { [0 Red] [1 pigment_pattern { boxed } ] }] } } }
