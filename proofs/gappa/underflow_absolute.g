# Theorem 1, guard: below twice the least normal number the error of a rounding is at most half the least subnormal number.
@rnd = float<ieee_64, ne>;
v = rnd(x);
{ |x| <= 1b-1021 -> |v - x| <= 1b-1075 }
