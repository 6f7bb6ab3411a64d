"""Euler's and Poisson's equations of a heavy body, with the axis of Chaplygin's case."""

from kowalevski_cas import System

top = System(
    r"4\dot p=3qr,\quad 4\dot q=-3pr-n,\quad \dot r=m,\quad \dot l=rm-qn,\quad \dot m=pn-rl,\quad \dot n=ql-pm"
)
top.integral("l^2+m^2+n^2")
