#declare Shiny = finish { phong 1 }
sphere { 0, 1 finish { diffuse 0 Shiny } }
sphere { 0, 1 finish { phong_size 3 Shiny } }
sphere { 0, 1 finish { Shiny Shiny } }
