text { ttf "a.png" "A" 1 0 }
text { "A" 1 0 }
text { ttf "letters.ttf" 1 0 }
text { ttf "letters.ttf" "A" }
text { ttf "letters.ttf" "A" 1/0 0 }
text { ttf "letters.ttf" "A" 1 }
text { ttf "letters.ttf" "A" 1 0 open }
text { internal -1 "A" 1 0 }
