blob { kernel "gaussian" hardness 4 skeleton on convolution off sphere { 0, 1 } }
global_settings { solver "hermite" tolerance "0.05px" }
#declare kernel = 3;
#macro hardness(tolerance) solver { tolerance } #end
