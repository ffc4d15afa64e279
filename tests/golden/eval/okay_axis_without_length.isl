#debug vstr(3, vaxis_rotate(x, 0, 90), ", ", 0, 1)
