#declare deprecated Old = 1;
#declare deprecated once "use New" Older = 2;
