blob { kernel "gausian" sphere { 0, 1 } }
blob { kernel "gaussian" hardness 0 sphere { 0, 1 } }
blob { kernel "gaussian" hardness -4 sphere { 0, 1 } }
blob { kernel "gaussian" hardness 501 sphere { 0, 1 } }
blob { kernel "gaussian" sphere { 0, 1, 2 } }
blob { cone { 0, 1, y, 2 } }
