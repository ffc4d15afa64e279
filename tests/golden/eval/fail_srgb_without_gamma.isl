#version 3.6;
#declare A = srgb 1;
