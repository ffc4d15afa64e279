#version 3.6;
#debug concat(str(version, 0, 2), "\n")
#declare Kept = version;
#version 3.7;
#debug concat(str(version, 0, 2), "\n")
#version Kept;
#debug concat(str(version, 0, 2), "\n")
