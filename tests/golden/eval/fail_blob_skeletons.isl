blob { box { 0, 1, 0.2 } }
blob { kernel "soft" torus { 2, 0 } }
blob { kernel "soft" torus { -1, 0.1 } }
blob { kernel "soft" triangle { 0, x, y } }
blob { kernel "soft" trangle { 0, x, y, 1 } }
blob { disc { 0, y, 1, 0.1 } }
blob { kernel "soft" disc { 0, 0, 1, 0.1 } }
blob { kernel "soft" disc { 0, y, 1 } }
blob { kernel "soft" disc { 0, y, -1, 0.1 } }
blob { kernel "quartic" convolution on disc { 0, y, 1, 0.1 } }
