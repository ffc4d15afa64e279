// Without an animation they are all 0 and clock_on is off, as in POV-Ray.
#debug concat(str(clock, 0, 3), str(clock_on, 2, 0), str(clock_delta, 6, 3), str(initial_clock, 6, 3))
#debug concat(str(final_clock, 6, 3), str(frame_number, 2, 0), str(initial_frame, 2, 0), str(final_frame, 2, 0), "\n")
#debug concat(str(image_width, 0, 0), "x", str(image_height, 0, 0), "\n")
#declare frame_number = 7;  // ordinary identifiers
#debug concat(str(frame_number, 0, 0), "\n")
