// POV-Ray ignores a `#` before a word and a colour among modifiers.
#union { sphere { 0, 1 rgb <1, 0, 0> } #sphere { x, 1 color red 0.5 translate y } }
