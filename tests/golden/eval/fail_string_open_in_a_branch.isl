// An error for POV-Ray 3.7 too, executed or not: "No end quote for string".
#if (0) " #end
