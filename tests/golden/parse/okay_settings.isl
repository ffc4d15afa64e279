#version 3.7;
#version Before;
#default { texture { finish { ambient 0 } } }
#include "colors.inc"
#include concat("a", ".inc")
#warning "careful"
#error "stop"
#render "old"
