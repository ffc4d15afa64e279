union {
  sphere { 0, (1 + 2 }
}
