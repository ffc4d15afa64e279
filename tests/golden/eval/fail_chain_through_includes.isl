#declare Size = "wide";
#include "calls_ball.inc"
