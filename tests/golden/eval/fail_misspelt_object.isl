sprehre { 0, 1 }
