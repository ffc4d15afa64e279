#version 3.8;
#declare Things = array mixed { 1, "two", <3, 3, 3> };
#debug Things[1]
