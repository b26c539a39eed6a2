"""Loads of a screw that turns: sector and slip found together. SI units.

Friction over the normal force, tau = T/N, of each contact is taken from the slip of the last round and kept while the
sector finds its normal forces; T_x of the sector is T_z of the slip model, T_y its T_x.
"""
from dataclasses import replace

import numpy as np
from slip import Slip


def solve(sector, slip_inputs):
    """Sector's result and slip's, in balance with each other."""
    state = sector.solve()
    for _ in range(60):
        slip = Slip(**slip_inputs, normal=tuple(list(n) for n in state["normal"])).solve()
        push = tuple([(at["traction"][2], at["traction"][0]) if at else (0.0, 0.0) for at in patches]
                     for patches in slip["patch"])
        new = replace(sector, push=push, result={}).solve()
        change = max(np.abs(a - b).max() for a, b in zip(new["normal"], state["normal"]))
        state = new
        if change < 1e-11 * max(n.max() for n in state["normal"]):
            return state, slip
    raise ArithmeticError("loads and friction do not settle")
