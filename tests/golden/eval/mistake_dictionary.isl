#version 3.8;
#declare Leaf = dictionary { .Size : 3, .Name : "oak" };
#debug Leaf.Name
