# in_ball on [-1,1]^3, radius <= 2: the error that Theorem 1 allows is gamma_6 m <= 6 u (1 + tiny) * 16 = 96 u (1 + tiny).
# IEEE double with gradual underflow, round to nearest. Formula: predicates/in_ball.hpp.
@rnd = float<ieee_64, ne>;
dx rnd= px - cx;  dy rnd= py - cy;  dz rnd= pz - cz;
v rnd= r * r - (dx * dx + dy * dy + dz * dz);
T = r * r - ((px - cx) * (px - cx) + (py - cy) * (py - cy) + (pz - cz) * (pz - cz));
{ |px| <= 1 /\ |py| <= 1 /\ |pz| <= 1 /\ |cx| <= 1 /\ |cy| <= 1 /\ |cz| <= 1 /\ r in [0, 2]
  -> |v - T| <= 97b-53 }
