// A dome theatre's picture.
#include "stage.inc"
Seen(camera { omnimax location <1, 3, -5> look_at y right 4/3*x })
