// What goes wrong with dictionaries.
#version 3.8;
#declare Leaf = dictionary { .Size: 3, ["Name"]: "oak" }
#declare A = Leaf.Sise;
#declare B = Leaf["weight"];
#undef Leaf.weight
#declare C = dictionary { .a: 1, .b: 2, .a: 3 }
#declare D = Leaf[1];
#declare E = dictionary { [5]: 1 }
#declare F = dictionary { Size: 3 }
#declare Leaf.stem.length = 1;
#declare List = array[2] { 1, 2 }
#declare G = List.x;
#declare H = List["x"];
#declare I = 5;
#declare J = I["x"];
#declare K = Leaf + 1;
