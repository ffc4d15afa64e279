// Without a size of its own it shows at look_at what a perspective camera would.
camera { orthographic location -5*z look_at 0 }
