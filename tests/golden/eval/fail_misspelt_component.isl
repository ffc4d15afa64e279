blob { spher { 0, 1, 1 } }
