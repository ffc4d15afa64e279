blob { kernel "gaussian" torus { 1, 1 } torus { 1, 0.9 } }
blob { kernel "quartic" convolution on torus { 1, 1.5 } }
