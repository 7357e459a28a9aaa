# certified_sign: the rounded product fl(c_K m), c_K >= (K + 2) u, is at least gamma_K m = ((1 + u)^K - 1) m for m without
# underflow; gamma_K <= (K + 1/2) u. Here K = 0, 4, 8, 12, 64, each divided by m.
@rnd = float<ieee_64, ne>;
b0 rnd= 2b-53 * m;
b4 rnd= 6b-53 * m;
b8 rnd= 10b-53 * m;
b12 rnd= 14b-53 * m;
b64 rnd= 66b-53 * m;
{ m in [1b-960, 1b1020] -> b0 / m >= 1b-54 /\ b4 / m >= 9b-54 /\ b8 / m >= 17b-54 /\ b12 / m >= 25b-54 /\ b64 / m >= 129b-54 }
