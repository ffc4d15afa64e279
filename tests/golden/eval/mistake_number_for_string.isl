#declare Steps = 8;
#debug concat("Steps: ", Steps, "\n")
