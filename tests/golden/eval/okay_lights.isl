#declare Lamp = light_source { 0, rgb <1, .5, 0> translate 5*y }
light_source { Lamp translate x }
light_source { <1, 2, 3> color rgb 1 }
Lamp
