// `text`: letters of a font beside the scene; what it lacks is its sign for that.
text { ttf "letters.ttf" "AOI" 0.5, 0 }
text { ttf "letters" "I é", -0.5, <0.5, 0.1> }
text { ttf "letters.ttf", "AO", 1, 0.5*z rotate y*30 }
#declare Word = text { ttf "letters.ttf" "I" 1 0 }
text { Word translate x }
text { ttf "letters.ttf" "  " 1 0 }
text { ttf "letters.ttf" "A" 0 0 }
difference { box { 0, 1 } text { ttf concat("let", "ters.ttf") "O" 2 0 translate -z } }
