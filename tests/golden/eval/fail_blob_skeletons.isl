blob { box { 0, 1, 0.2 } }
blob { kernel "soft" torus { 2, 0 } }
blob { kernel "soft" triangle { 0, x, 2 * x, 0.1 } }
blob { kernel "soft" triangle { 0, x, y } }
blob { kernel "soft" trangle { 0, x, y, 1 } }
