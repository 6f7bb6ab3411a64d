\\ The k-th derivatives of functions, and the powers of a matrix, as recursive polynomials.
v = [$variables];
rates = [$rates];
E(p) = sum(i = 1, #v, deriv(p, v[i])*rates[i]);
d = $divisor;
e = E(d);
l = $factor;
F = [$functions]~;
M = matrix(2, 2, i, j, [$matrix][2*i + j - 2]);
work() =
{
  my(P = F, N = matid(2), both = 1, p = $pole);
  for(k = 1, $most,
    P = l*E(P) - p*e*P;
    p += $rise;
    N = d^$rest*(d*E(N) - (k - 1)*$order*e*N) + N*M;
    both *= d^$gap;
    if(both*P != N*F, print("fails"); quit);
    print("step ", k));
}
print("step 0");
work();
quit;
