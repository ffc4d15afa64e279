// The order of the items does not matter; `angle` is horizontal and sets the length of direction.
#declare Lens = camera { angle 90 right 2*x }
camera { Lens look_at <0, 0, 1> location <0, 0, -1> rotate 90*y }
