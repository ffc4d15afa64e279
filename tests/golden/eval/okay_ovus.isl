// An egg: the bottom radius, then the top radius, which is below twice the bottom radius.
ovus { 1, .6 }
ovus { .6 1 sturm off rotate 90*x }
// Without a top radius it is the sphere at its bottom.
ovus { 2, 0 }
#declare Egg = ovus { .5, .3 }
ovus { Egg translate x }
// POV-Ray takes the sphere of the top radius for what that holds all of.
ovus { 1, 2 }
ovus { 0, .5 }
ovus { 0, 0 }
