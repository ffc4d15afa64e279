// Dictionaries: keys, values of all kinds, copies, references.
#version 3.8;
global_settings { assumed_gamma 1 }
#macro Say(Name, V) #debug concat(Name, " ", str(V, 0, 6), "\n") #end
#declare D = dictionary { ["a"]: 1, .B: <1, 2, 3>, ["c d"]: "text", }
Say("a key in brackets", D["a"])
Say("the same after a dot", D.a)
Say("a key after a dot", D["B"].y)
Say("an item of a value", D.B.z)
#debug concat("a key with a blank ", D["c d"], "\n")
#declare Empty = dictionary;
#declare Empty.first = 4;
#declare Empty["second"] = 5;
Say("added", Empty["first"] + 10*Empty.second)
#declare Empty.first = Empty.first + 1;
Say("changed", Empty.first)
Say("there", defined(D.a) + 10*defined(D["a"]))
Say("not there", defined(D.z) + 10*defined(D["z"]))
#ifdef (D.B) Say("ifdef", 1) #else Say("ifdef", 0) #end
#ifndef (D["nothing"]) Say("ifndef", 1) #else Say("ifndef", 0) #end
#undef D["a"]
Say("removed", defined(D.a))
#declare Items = dictionary { .x: 1, .t: 2, .red: 3, .gray: 4 }
Say("keys that vectors know", Items.x + 10*Items.t + 100*Items["red"] + 1000*Items.gray)
#declare Deep = dictionary { .a: dictionary { .b: dictionary { .c: 7 } } }
Say("three deep", Deep.a.b.c)
Say("mixed", Deep["a"].b["c"])
#declare Deep.a.n = 8;
Say("written deep", Deep["a"]["n"])
#declare Lists = dictionary { .n: array[2] { 5, 6 }, .m: array[2][2] { { 1, 2 }, { 3, 4 } } }
Say("an array in a dictionary", Lists.n[1] + Lists.m[1][0])
#declare Lists.n[0] = 50;
Say("its element written", Lists["n"][0])
#declare Held = array[2];
#declare Held[0] = dictionary { .a: 3 }
#declare Held[0].b = 4;
Say("a dictionary in an array", Held[0].a + 10*Held[0].b)
#declare Squares = dictionary;
#for (I, 1, 5) #declare Squares[str(I, 0, 0)] = I*I; #end
Say("keys of expressions", Squares["4"] + Squares[concat("5", "")])
#declare Made = dictionary { #for (I, 1, 3) [concat("k", str(I, 0, 0))]: 2*I, #end .last: 9 }
Say("fields of a loop", Made.k3 + 10*Made.last)
#declare Twice = dictionary { .a: 1, .a: 2 }
Say("a key twice", Twice.a)
#declare Shapes = dictionary { .ball: sphere { 0, 2 }, .colour: rgb <1, 0.5, 0>, .f: function (x) { x*2 } }
Say("an object", max_extent(Shapes.ball).x)
Say("a colour", Shapes.colour.green)
Say("a function", Shapes.f(3))
#declare F = function (x) { x*Squares["3"] + x*Made.k1 }
Say("values in a function", F(2))
#macro Set(Q) #declare Q.a = 8; #declare Q.fresh = 9; #end
Set(Twice)
Say("written by a macro", Twice.a + 10*Twice.fresh)
#macro Change(X) #declare X = X + 100; #end
Change(Twice.a)
Say("a value by reference", Twice.a)
Change(Held[0].b)
Say("one in an array by reference", Held[0].b)
#macro Of(Q, Key) Q[Key] #end
Say("a key as argument", Of(Squares, "2"))
#declare Sum = D.B + Squares["2"];
Say("in arithmetic", Sum.z)
Say("in a condition", (Squares["2"] = 4 & Made.k1 < 3 ? 1 : 0))
