// String functions; printed by POV-Ray 3.7 alike.
#version 3.7;
#debug concat(str(2.5, -8, 2), "|", str(2.5, 8, -1), "|", str(2.5, 0, 0), "|", str(1234567.891, 0, -1), "|", str(-1.5, -8, 1), "\n")
#debug concat(vstr(3, <1, 2, 3>, ", ", 5, 1), "|", vstr(2, <1, 2, 3>, ";", 0, -1), "|", vstr(2, 5, "/", 0, 1), "\n")
#debug concat(chr(65), substr("abcdef", 2, 3), strupr("abc"), strlwr("ABC"), "\n")
#debug concat(str(strlen("abc"), 0, 0), str(strcmp("a", "b"), 0, 0), str(strcmp("b", "a"), 0, 0), str(asc("A"), 0, 0), "\n")
#debug concat(str(val("3.5"), 0, 2), " ", str(val("abc"), 0, 2), " ", str(val("-1e2"), 0, 2), "\n")
#declare S = "tail" #debug concat("head ", S, "\n")
