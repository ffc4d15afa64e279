// Files that are missing or of another kind, and broken fonts. What is wrong within an image is told when it is drawn.
sphere { 0, 1 pigment { image_map { webp "a.png" } } }
sphere { 0, 1 normal { bump_map { png "none.png" } } }
text { ttf "broken.ttf" "A" 1 0 }
text { ttf "b.jpg" "A" 1 0 }
