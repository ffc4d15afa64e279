// Looking down, with a mirrored `right`.
camera { location 5*y right -1.33*x look_at 0 }
