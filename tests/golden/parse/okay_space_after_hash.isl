#  declare A = 1;
# if (A) A # end
