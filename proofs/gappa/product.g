# Theorem 1, product rule without underflow: factors with relative errors (1 + u)^I - 1 and (1 + u)^J - 1 give a rounded
# product with relative error (1 + u)^(I+J+1) - 1; here I = J = 1, K = 3: 3 u + 3 u^2 + u^3 <= 24577/8192 u, u = 2^-53.
@rnd = float<53, ne>;
v rnd= a * b;
T = ta * tb;
{ a -/ ta in [-1b-53, 1b-53] /\ b -/ tb in [-1b-53, 1b-53] -> v -/ T in [-24577b-66, 24577b-66] }
