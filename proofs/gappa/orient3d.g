# orient3d on [-1,1]^3: the error that Theorem 1 allows is gamma_8 m <= 8 u (1 + tiny) * 48 = 384 u (1 + tiny), u = 2^-53.
# IEEE double with gradual underflow, round to nearest. Formula: predicates/orient3d.hpp.
@rnd = float<ieee_64, ne>;
ax rnd= px - sx;  ay rnd= py - sy;  az rnd= pz - sz;
bx rnd= qx - sx;  by rnd= qy - sy;  bz rnd= qz - sz;
cx rnd= rx - sx;  cy rnd= ry - sy;  cz rnd= rz - sz;
v rnd= (bx * ay - by * ax) * cz + (by * cx - bx * cy) * az + (ax * cy - ay * cx) * bz;
Ax = px - sx;  Ay = py - sy;  Az = pz - sz;
Bx = qx - sx;  By = qy - sy;  Bz = qz - sz;
Cx = rx - sx;  Cy = ry - sy;  Cz = rz - sz;
T = (Bx * Ay - By * Ax) * Cz + (By * Cx - Bx * Cy) * Az + (Ax * Cy - Ay * Cx) * Bz;
{ |px| <= 1 /\ |py| <= 1 /\ |pz| <= 1 /\ |qx| <= 1 /\ |qy| <= 1 /\ |qz| <= 1
  /\ |rx| <= 1 /\ |ry| <= 1 /\ |rz| <= 1 /\ |sx| <= 1 /\ |sy| <= 1 /\ |sz| <= 1
  -> |v - T| <= 385b-53 }
