#declare Wide = 2
#declare Tall = 7;
cylinder { 0, Tall*y, Wide }
