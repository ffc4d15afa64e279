// `kernel`, `hardness`, `solver` and `tolerance` are not reserved, and what follows them may begin with a sign or a bracket.
#declare kernel = 3;
#declare hardness = 5;
#macro tolerance() 1e-3 #end
global_settings { solver "hermite" tolerance 1e-3 }
blob { kernel "gaussian" hardness hardness sphere { 0, kernel } }
blob { kernel "quartic" hardness (1 + 1) sphere { 0, tolerance() } }
blob { kernel "quartic" hardness +7 - 1 sphere { 0, 1 } }
