blob { kernel "quartic" convolution on sphere { 0, 1 } }
blob { kernel "cauchy" convolution on cone { 0, 1, x, 0.5 } }
blob { kernel "gaussian" convolution on cylinder { 0, x, 0.2 } }
blob { convolution on cylinder { 0, x, 0.2, 1 } }
blob { kernel "quartic" convolution cylinder { 0, x, 0.2 } }
blob { convolution on component 1, 1, <0, 0, 0> }
blob { kernel "soft" convolution on plane { y, 1, 0.2 } }
blob { kernel "quartic" convolution on plane { y, 1, 0 } }
