blob { kernel "soft" sphere { 0, 1 } blob { sphere { x, 1 } no_shadow } }
blob { kernel "soft" sphere { 0, 1 } union { sphere { x, 1 } threshold 1 } }
blob { kernel "soft" plane { 0, 1, 0.1 } }
blob { kernel "soft" sphere { 0, 1 } blob { 3 } }
blob { kernel "soft" sphere { 0, 1 } intersection { sphere { 0, 1 } } }
blob {
  kernel "soft"
  #for (I, 0, 12) union { sphere { I * x, 1 } sphere { I * y, 1 } } #end
}
blob { kernel "soft" sphere { 0, 1 } blob { skeleton on sphere { x, 1 } } }
