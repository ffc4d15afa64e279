#macro Twig(K) cylinder { 0, y, 0.1 } Twig(K - 1) #end
Twig(5)
