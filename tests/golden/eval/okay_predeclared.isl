// Isl tells one program from the other; the image's size is known.
#ifdef (Isl) #debug concat("isl ", str(Isl, 0, 1), "\n") #end
#debug concat(str(image_width, 0, 0), "x", str(image_height, 0, 0), " ", str(clock, 0, 1), " ", str(frame_number, 0, 0), "\n")
