# Theorem 1, leaf rule: a difference of two doubles has relative error at most u = 2^-53, also when it is subnormal.
@rnd = float<ieee_64, ne>;
p = rnd(p0);
q = rnd(q0);
v rnd= p - q;
{ |p| <= 1b1022 /\ |q| <= 1b1022 -> |v -/ (p - q)| <= 1b-53 }
