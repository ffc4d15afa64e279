// B failed; what is made from it fails silently.
#declare B = Missing + 1;
#declare C = B * 2;
sphere { 0, C }
