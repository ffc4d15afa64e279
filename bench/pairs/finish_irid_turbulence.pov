// A film of uneven thickness, with wavelengths of its own.
#include "stage.inc"
global_settings { irid_wavelength rgb <0.25, 0.18, 0.14> }
Finished(finish { ambient 0 diffuse 0.6 irid { 0.5 thickness 0.5 turbulence 0.4 } })
