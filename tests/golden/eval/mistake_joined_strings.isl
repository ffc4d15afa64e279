#declare Title = "oak" + "leaf";
#declare Count = "oaks: " + 3;
#declare Less = "oak" - "k";
