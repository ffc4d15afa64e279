#version 3.71;
#debug concat(str(version, 0, 2), "\n")
#version 3.9;
#version 3.8;
#debug concat(str(version, 0, 2), "\n")
