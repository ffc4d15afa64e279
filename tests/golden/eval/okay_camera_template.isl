// The customary template with z upwards. Its right is along its direction, and the sky is up.
camera { sky z direction -x right <-4/3, 0, 0> location <10, 0, 3> look_at 0 }
