// The parts of a torus whose minor radius is the greater; other tori have none.
torus { 0.5, 1 sturm }
torus { 0.5, 1 merge pigment { rgb 1 } }
torus { 0.5, 1 intersection }
torus { 0.5, 1 difference translate x }
torus { 0.5, 1 union }
torus { 1, 0.5 difference }
torus { 1, 0.5 intersection }
