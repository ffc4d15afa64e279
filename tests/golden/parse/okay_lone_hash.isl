camera { look_at <0, 0, 0> #
}
