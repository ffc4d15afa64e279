// The parts of a torus whose minor radius is the greater, met by rays and asked for points.
#version 3.8;
global_settings { assumed_gamma 1 }
#macro Say(Name, V) #debug concat(Name, " ", str(V, 0, 6), "\n") #end
#macro Ask(Name, Object)
  Say(concat(Name, ": the middle is inside"), inside(Object, 0))
  Say(concat(Name, ": the ring is inside"), inside(Object, x))
  Say(concat(Name, ": beyond it"), inside(Object, 1.6*x))
  Say(concat(Name, ": the first place along x"), trace(Object, -3*x, x).x)
  Say(concat(Name, ": from within, along y"), trace(Object, <1, -3, 0.2>, y).y)
#end
Ask("difference", torus { 0.5, 1 difference })
Ask("intersection", torus { 0.5, 1 intersection })
Ask("merge", torus { 0.5, 1 merge })
#declare Spindle = torus { 0.5, 1 intersection }
#declare Normal = <0, 0, 0>;
#declare Place = trace(Spindle, <0.1, 3, 0.05>, -y, Normal);
Say("the spindle's height", Place.y)
Say("its normal", Normal.x)
Say("its normal upwards", Normal.y)
#declare Shell = torus { 0.5, 1 difference }
#declare Place = trace(Shell, <0, 0, 0>, <1, 0.2, 0>, Normal);
Say("out of the hollow", Place.x)

// An ovus with controls.
#macro Ask_ovus(Name, Object)
  Say(concat(Name, ": inside"), inside(Object, <0.9, 0.6, 0>))
  #local Place = trace(Object, <-5, 0.5, 0.3>, x, Normal);
  Say(concat(Name, ": in the middle"), Place.x)
  Say(concat(Name, ": its normal"), Normal.y)
  Say(concat(Name, ": at the bottom"), trace(Object, <0.1, -5, 0.1>, y).y)
  Say(concat(Name, ": at the top"), trace(Object, <0.1, 9, 0.1>, -y).y)
#end
Ask_ovus("radius", ovus { 1, 0.6 radius 4 })
Ask_ovus("distance", ovus { 1, 0.6 distance 1.5 radius 2 })
Ask_ovus("only distance", ovus { 1, 0.6 distance 1.1 })
Ask_ovus("top is greater", ovus { 0.7, 1 distance 0.9 radius 3 precision 0.001 })
Ask_ovus("least radius", ovus { 1, 0.5 distance 2 radius 1.75 })
Ask_ovus("without top", ovus { 1, 0 distance 2 radius 5 sturm })
