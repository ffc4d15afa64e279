global_settings {
  adc_bailout .01 ambient_light rgb .5 assumed_gamma 1.8 charset utf8 hf_gray_16 on irid_wavelength rgb <.3, .2, .1>
  max_intersections 128 max_trace_level 300 mm_per_unit 25.4 number_of_waves 0 noise_generator 3
  solver "paper:3" tolerance "0.1px"
}
