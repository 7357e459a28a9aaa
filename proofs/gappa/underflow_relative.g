# Theorem 1, guard: from twice the least normal number on, the error of a rounding is relative.
@rnd = float<ieee_64, ne>;
v = rnd(x);
{ x in [1b-1021, 1b1023] -> v -/ x in [-1b-53, 1b-53] }
