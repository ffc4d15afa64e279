// A macro's texture, and the layers behind its call.
#macro Base(C) texture { pigment { rgb C } } #end
#declare Two = Base(x) texture { pigment { rgbt <0, 1, 0, 0.5> } }
#declare Three = Base(y) texture { pigment { rgbt <0, 1, 0, 0.5> } } texture { pigment { rgbt <0, 0, 1, 0.7> } }
sphere { 0, 1 texture { Two } }
sphere { 0, 1 texture { Three } }
#declare One = Base(z);
sphere { 0, 1 #declare Inner = Base(1) texture { pigment { rgbt 0.5 } }; texture { Inner } }
sphere { 0, 1 texture { One } }
