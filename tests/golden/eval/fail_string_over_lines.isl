// POV-Ray reads a string to the next quote, in whichever line that stands, and complains of what follows it.
#include "colors.inc
sphere { 0, 1 }
#debug "found"
