#declare Turned = vaxis_rotate(x, 0, 90);
