// In a scene of 3.7 the words of 3.8 are names like any other.
#version 3.7;
#declare blend_gamma = 1; #declare blend_mode = 2; #declare bt2020 = 3; #declare bt709 = 4; #declare dictionary = 5;
#declare global = 6; #declare grey = rgb 7; #declare hf_grey_16 = 8; #declare lemon = 9; #declare grey_threshold = <10, 11, 12>;
#declare mixed = 13; #declare polarity = 14; #declare potential = 15; #declare tau = 16; #declare user_defined = 17;
#declare optional = 18;
#debug concat(str(blend_gamma + blend_mode + bt2020 + bt709 + dictionary + global, 0, 0), "\n")
#debug concat(str(grey.red + hf_grey_16 + lemon + grey_threshold.y + mixed + polarity + potential + tau + user_defined, 0, 0), "\n")
#macro Of(optional, global) #debug concat(str(optional + global, 0, 0), "\n") #end
Of(optional, global)
#local global = global * 2;
#for (mixed, 1, 2) #debug concat(str(mixed * global, 0, 0), "\n") #end
#declare List = array[3] { optional, dictionary, tau }
#debug concat(str(List[0] + List[1] + List[2], 0, 0), "\n")
#macro lemon() sphere { 0, 1 } #end
lemon()
