union { object { Wheel translate x } object { Wheel translate -x } }
