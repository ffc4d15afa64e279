camera { }
