// Lines that end by CR, by LF, by both, and by both the other way round: comments, strings and data.
#version 3.7;
#macro Codes(Name, S)
  #debug Name
  #for (I, 1, strlen(S)) #debug concat(" ", str(asc(substr(S, I, 1)), 0, 0)) #end
  #debug "\n"
#end
#include "line_ends_lf.inc"
#include "line_ends_cr.inc"
#include "line_ends_crlf.inc"
#include "line_ends_lfcr.inc"
#
declare Apart = 1;
#debug concat("the word of a directive in the next line ", str(Apart, 0, 0), "\n")
