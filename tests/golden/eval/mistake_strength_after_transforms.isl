blob { kernel "gaussian" sphere { 0, 1 scale <1,2,1> strength 2 } }
