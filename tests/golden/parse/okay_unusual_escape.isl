image_map { png "maps\wood.png" }
