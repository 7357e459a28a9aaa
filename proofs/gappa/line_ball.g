# line_ball on [-1,1]^3, radius <= 2: Theorem 1 allows gamma_12 m <= 12 u (1 + tiny) * 240 = 2880 u (1 + tiny), u = 2^-53.
# IEEE double with gradual underflow, round to nearest. Formula: predicates/line_ball.hpp.
@rnd = float<ieee_64, ne>;
dx rnd= qx - px;  dy rnd= qy - py;  dz rnd= qz - pz;
ex rnd= cx - px;  ey rnd= cy - py;  ez rnd= cz - pz;
nx rnd= ey * dz - ez * dy;  ny rnd= ez * dx - ex * dz;  nz rnd= ex * dy - ey * dx;
v rnd= (r * r) * (dx * dx + dy * dy + dz * dz) - (nx * nx + ny * ny + nz * nz);
Dx = qx - px;  Dy = qy - py;  Dz = qz - pz;
Ex = cx - px;  Ey = cy - py;  Ez = cz - pz;
Nx = Ey * Dz - Ez * Dy;  Ny = Ez * Dx - Ex * Dz;  Nz = Ex * Dy - Ey * Dx;
T = (r * r) * (Dx * Dx + Dy * Dy + Dz * Dz) - (Nx * Nx + Ny * Ny + Nz * Nz);
{ |px| <= 1 /\ |py| <= 1 /\ |pz| <= 1 /\ |qx| <= 1 /\ |qy| <= 1 /\ |qz| <= 1
  /\ |cx| <= 1 /\ |cy| <= 1 /\ |cz| <= 1 /\ r in [0, 2]
  -> |v - T| <= 2881b-53 }
