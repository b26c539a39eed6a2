"""Case 01 from its README alone."""
import csv
import sys
from math import cos, pi, radians

from scipy.optimize import fsolve

N_R, P, E, F = 8, 0.005 / 3, 209e9, 8000.0
D_S, D_R, D_N, BORE, D_OUT = 0.021, 0.007, 0.035, 0.006, 0.046
K_S, K_N, PSI = 1.138419958e10, 1.328156617e10, radians(45)

f = F / N_R
c_s = P * N_R / (E * pi / 4 * (D_S**2 - BORE**2))
c_n = P * N_R / (E * pi / 4 * (D_OUT**2 - D_N**2))
c_r = P / (E * pi / 4 * D_R**2)


def delta(load, k):
    return (load / (k * cos(PSI))) ** (2 / 3) / cos(PSI)


def equations(unknown):
    p, q = (f * x for x in unknown)  # of the second threads
    roller = (q - p) * c_r
    return (1e6 * (delta(p, K_S) - delta(f - p, K_S) - roller + p * c_s),
            1e6 * (delta(q, K_N) - delta(f - q, K_N) + roller + q * c_n))


p, q = (f * x for x in fsolve(equations, (0.5, 0.5), xtol=1e-14))
u = f * c_s * 0.010 / P + delta(f - p, K_S) + delta(f - q, K_N) + f * c_n * 0.010 / P
rows = [("thread_load_screw_1_N", (f - p) / cos(PSI)), ("thread_load_screw_2_N", p / cos(PSI)),
        ("thread_load_nut_1_N", (f - q) / cos(PSI)), ("thread_load_nut_2_N", q / cos(PSI)),
        ("displacement_um", 1e6 * u), ("stiffness_N_per_um", 1e-6 * F / u)]
out = csv.writer(sys.stdout)
out.writerow(("case", "quantity", "value"))
out.writerows(("01", *row) for row in rows)
