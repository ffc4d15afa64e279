// Numbers that media and mirrors cannot have. An `ior` of 0 is one of 1, and a mirror may give more than it gets, as in POV-Ray.
sphere { 0, 1 interior { ior 0 } }
sphere { 0, 1 interior { ior "1.5" } }
sphere { 0, 1 interior { fade_distance -1 fade_power 2 } }
sphere { 0, 1 interior { dispersion 0 } }
sphere { 0, 1 interior { dispersion 1.1 dispersion_samples 1 } }
sphere { 0, 1 finish { reflection 2 } }
sphere { 0, 1 finish { reflection { 0.5 exponent 0 } } }
fog { distance -5 rgb 1 }
global_settings { max_trace_level 0 }
