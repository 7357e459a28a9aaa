# orient2d on [-1,1]^2: the error that Theorem 1 allows is gamma_4 m <= 4 u (1 + tiny) * 8 = 32 u (1 + tiny), u = 2^-53.
# IEEE double with gradual underflow, round to nearest. Formula: predicates/orient2d.hpp.
@rnd = float<ieee_64, ne>;
ax rnd= px - rx;  ay rnd= py - ry;
bx rnd= qx - rx;  by rnd= qy - ry;
v rnd= ax * by - ay * bx;
T = (px - rx) * (qy - ry) - (py - ry) * (qx - rx);
{ |px| <= 1 /\ |py| <= 1 /\ |qx| <= 1 /\ |qy| <= 1 /\ |rx| <= 1 /\ |ry| <= 1
  -> |v - T| <= 33b-53 }
