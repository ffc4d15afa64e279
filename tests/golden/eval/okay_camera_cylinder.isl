#declare Round = camera { cylinder 2 angle 120 location z }
camera { Round translate x }
