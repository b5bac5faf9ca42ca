"""The ballistic limit of a pointed rigid projectile by cylindrical cavity expansion (Forrestal & Warren; Masri 2010 and
others): the formula that a simulation must beat on plates of ductile metal."""

import math

# Diameter, m, and mass, kg, of the hard cores of the bullets in apps/data/v50_open.csv.
CORES = {"7.62 mm APM2": (6.17e-3, 5.25e-3), "7.62 mm APM2 core": (6.17e-3, 5.25e-3)}


def expansion_stress(yield_stress, young, exponent):
    """Stress, Pa, that opens a cylindrical cavity in a metal with sigma = Y (E eps/Y)^n beyond yield Y: Y/sqrt(3) (1 +
    (E/(sqrt(3) Y))^n I), I the integral of (-ln x)^n/(1 - x) from 0 to 1 - sqrt(3) Y/E."""
    def integrand(u):  # x = exp(-exp(u)): smooth, and the lower end is far away
        t = math.exp(u)
        return t ** (exponent + 1) * math.exp(-t) / -math.expm1(-t)

    begin, end, intervals = math.log(-math.log(1 - math.sqrt(3) * yield_stress / young)), math.log(60), 2000
    width = (end - begin) / intervals
    simpson = sum((1 if k in (0, intervals) else 4 if k % 2 else 2) * integrand(begin + k * width)
                  for k in range(intervals + 1)) * width / 3
    return yield_stress / math.sqrt(3) * (1 + (young / (math.sqrt(3) * yield_stress)) ** exponent * simpson)


def limit_mps(test):
    """The limit of a row of v50_open.csv; None where the formula does not apply: other projectiles, oblique impact, no
    constants."""
    core = CORES.get(test["projectile"])
    names = ("yield_MPa", "young_GPa", "ludwik_n", "thickness_mm")
    if core is None or float(test["obliquity_deg"]) != 0 or not all(test[name] for name in names):
        return None
    yield_mpa, young_gpa, exponent, thickness_mm = (float(test[name]) for name in names)
    diameter, mass = core
    stress = expansion_stress(1e6 * yield_mpa, 1e9 * young_gpa, exponent)
    return math.sqrt(2 * stress * 1e-3 * thickness_mm * math.pi * (diameter / 2) ** 2 / mass)
