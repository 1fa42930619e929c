"""Independent solvers behind one signature: Problem -> (status, x or None).

"solved" and "infeasible" are verdicts; any other status is the solver's own word for having no verdict. For solvers with
linear rows only, tangent planes replace second-order cones; planes are added until no cone is violated.
"""

import math
import time
from dataclasses import dataclass

import numpy as np
import scipy.sparse as sp

PATIENCE = 60.0  # s that a solver gets for one problem
CUT = 1e-7  # a cone may be passed by this much where tangent planes stand in for it


@dataclass
class Problem:
    """minimise 1/2 x'P x + q'x + constant subject to A x + s = b, s in a product of cones.

    P is symmetric and complete; `cones` lists (kind, rows), the kinds being zero, nonnegative and second_order.
    """

    P: sp.csc_matrix
    q: np.ndarray
    constant: float
    A: sp.csr_matrix
    b: np.ndarray
    cones: list

    def objective(self, x):
        return float(0.5 * x @ (self.P @ x) + self.q @ x + self.constant)

    def spans(self, wanted):
        """(first row, last row + 1) of each cone of a kind."""
        ends = np.cumsum([n for _, n in self.cones])
        return [(int(end) - n, int(end)) for (kind, n), end in zip(self.cones, ends) if kind == wanted]

    def part(self, *kinds):
        """A and b of all rows of the given kinds, one kind after the other."""
        pick = [np.arange(i, j) for kind in kinds for i, j in self.spans(kind)]
        pick = np.concatenate(pick) if pick else np.array([], dtype=int)
        return self.A[pick], self.b[pick]

    def cone_sizes(self):
        return [j - i for i, j in self.spans("second_order")]

    def violation(self, x):
        """The largest violation of the cones by b - A x."""
        s = self.b - self.A @ x
        worst = [np.abs(s[i:j]).max() for i, j in self.spans("zero")]
        worst += [-s[i:j].min() for i, j in self.spans("nonnegative")]
        worst += [np.linalg.norm(s[i + 1 : j]) - s[i] for i, j in self.spans("second_order")]
        return float(max([0.0, *worst]))


def verdict(status, solved, infeasible, x):
    if status == solved:
        return "solved", np.array(x)
    return ("infeasible" if status == infeasible else status), None


def with_clarabel(p):
    import clarabel

    kinds = {
        "zero": clarabel.ZeroConeT,
        "nonnegative": clarabel.NonnegativeConeT,
        "second_order": clarabel.SecondOrderConeT,
    }
    settings = clarabel.DefaultSettings()
    settings.verbose, settings.max_threads = False, 1
    cones = [kinds[kind](n) for kind, n in p.cones]
    answer = clarabel.DefaultSolver(sp.triu(p.P, format="csc"), p.q, p.A.tocsc(), p.b, cones, settings).solve()
    return verdict(str(answer.status), "Solved", "PrimalInfeasible", answer.x)


def with_scs(p):
    import scs

    A, b = p.part("zero", "nonnegative", "second_order")
    data = {"P": sp.triu(p.P, format="csc"), "c": p.q, "A": A.tocsc(), "b": b}
    linear = [sum(j - i for i, j in p.spans(kind)) for kind in ("zero", "nonnegative")]
    cone = {"z": linear[0], "l": linear[1], "q": p.cone_sizes()}
    limits = {"max_iters": 1_000_000, "time_limit_secs": PATIENCE}
    answer = scs.SCS(data, cone, verbose=False, eps_abs=1e-8, eps_rel=1e-8, **limits).solve()
    return verdict(answer["info"]["status"], "solved", "infeasible", answer["x"])


def with_ecos(p):
    """ECOS wants a linear objective: minimise t + q'x with |(sqrt(2) F x, t - 1)| <= t + 1 and F'F = P."""
    import ecos

    F = square_root(p.P)
    k, n = F.shape
    G, h = p.part("nonnegative", "second_order")
    A, b = p.part("zero")
    wide = sp.bmat([[G, None], [None, [[-1.0]]], [-math.sqrt(2) * F, None], [None, [[-1.0]]]], format="csc")
    h = np.concatenate([h, [1.0], np.zeros(k), [-1.0]])
    dims = {"l": sum(j - i for i, j in p.spans("nonnegative")), "q": [*p.cone_sizes(), k + 2]}
    equal = sp.hstack([A, sp.csr_matrix((A.shape[0], 1))], format="csc")
    answer = ecos.solve(np.append(p.q, 1.0), wide, h, dims, equal, b, verbose=False, max_iters=200)
    return verdict(answer["info"]["infostring"], "Optimal solution found", "Primal infeasible", answer["x"][:n])


def square_root(P):
    """Sparse F with F'F = P (positive semidefinite), from the eigenvalues of its connected blocks."""
    count, label = sp.csgraph.connected_components(P, directed=False)
    order = np.argsort(label, kind="stable")
    rows = [sp.csr_matrix((0, P.shape[0]))]
    for block in np.split(order, np.cumsum(np.bincount(label, minlength=count))[:-1]):
        value, vector = np.linalg.eigh(P[np.ix_(block, block)].toarray())
        keep = value > 1e-14 * max(value[-1], 0.0)
        factor = sp.coo_matrix(np.sqrt(value[keep])[:, None] * vector[:, keep].T)
        rows.append(sp.csr_matrix((factor.data, (factor.row, block[factor.col])), (factor.shape[0], P.shape[0])))
    return sp.vstack(rows, format="csr")


def by_tangents(solver):
    """Extends a solver of linear rows, called as solver(problem, G, h) with G x <= h, to cones."""

    def solve(p):
        G, h = ([m] for m in p.part("nonnegative"))
        for i, j in p.spans("second_order"):  # at first |s_k| <= s_0 for each k
            head = sp.vstack([p.A[[i]]] * (j - i - 1))
            G += [head + p.A[i + 1 : j], head - p.A[i + 1 : j]]
            h += [p.b[i] + p.b[i + 1 : j], p.b[i] - p.b[i + 1 : j]]
        begin = time.perf_counter()
        while time.perf_counter() - begin < PATIENCE:
            status, x = solver(p, sp.vstack(G, format="csc"), np.concatenate(h))
            if x is None:
                return status, None
            s, passed = p.b - p.A @ x, False
            for i, j in p.spans("second_order"):
                length = np.linalg.norm(s[i + 1 : j])
                if length > s[i] + CUT:
                    direction = s[i + 1 : j] / length
                    G.append(p.A[[i]] - sp.csr_matrix(direction) @ p.A[i + 1 : j])
                    h.append(p.b[[i]] - direction @ p.b[i + 1 : j])
                    passed = True
            if not passed:
                return status, x
        return "out of time", None

    return solve


def osqp_rows(p, G, h):
    import osqp

    A, b = p.part("zero")
    lower, upper = np.concatenate([b, np.full(len(h), -np.inf)]), np.concatenate([b, h])
    limits = {"max_iter": 1_000_000, "time_limit": PATIENCE, "eps_abs": 1e-8, "eps_rel": 1e-8, "polishing": True}
    solver = osqp.OSQP()
    solver.setup(
        sp.triu(p.P, format="csc"), p.q, sp.vstack([A, G], format="csc"), lower, upper, verbose=False, **limits
    )
    answer = solver.solve()
    return verdict(answer.info.status, "solved", "primal infeasible", answer.x)


def piqp_rows(p, G, h):
    import piqp

    A, b = p.part("zero")
    solver = piqp.SparseSolver()
    solver.settings.eps_abs, solver.settings.eps_rel, solver.settings.max_iter = 1e-8, 1e-9, 1000
    solver.setup(p.P, p.q, A.tocsc(), b, G, np.full(len(h), -np.inf), h)
    status = solver.solve()
    return verdict(status.name, "PIQP_SOLVED", "PIQP_PRIMAL_INFEASIBLE", solver.result.x)


def quiet_highs():
    import highspy

    h = highspy.Highs()
    h.setOptionValue("output_flag", False)
    h.setOptionValue("time_limit", PATIENCE)
    # Along chains of integrators its active-set method drifts by some 1e-4 in the rows, which it then calls
    # an error unless allowed to; without any regularisation it takes the problem for a nonconvex one.
    h.setOptionValue("primal_feasibility_tolerance", 1e-3)
    h.setOptionValue("qp_regularization_value", 1e-9)
    return h


def highs_verdict(h):
    h.run()
    return verdict(h.modelStatusToString(h.getModelStatus()), "Optimal", "Infeasible", h.getSolution().col_value)


def highs_rows(p, G, h):
    import highspy

    A, b = p.part("zero")
    rows, infinity = sp.vstack([A, G], format="csc"), highspy.kHighsInf
    model, hessian = highspy.HighsModel(), sp.tril(p.P, format="csc")
    lp = model.lp_
    lp.num_col_, lp.num_row_, lp.col_cost_ = len(p.q), rows.shape[0], p.q
    lp.col_lower_, lp.col_upper_ = np.full(len(p.q), -infinity), np.full(len(p.q), infinity)
    lp.row_lower_, lp.row_upper_ = np.concatenate([b, np.full(len(h), -infinity)]), np.concatenate([b, h])
    lp.a_matrix_.format_ = highspy.MatrixFormat.kColwise
    lp.a_matrix_.start_, lp.a_matrix_.index_, lp.a_matrix_.value_ = rows.indptr, rows.indices, rows.data
    if hessian.nnz:
        model.hessian_.dim_, model.hessian_.format_ = len(p.q), highspy.HessianFormat.kTriangular
        model.hessian_.start_, model.hessian_.index_ = hessian.indptr, hessian.indices
        model.hessian_.value_ = hessian.data
    solver = quiet_highs()
    if solver.passModel(model) == highspy.HighsStatus.kError:
        return "refused", None
    return highs_verdict(solver)


SOLVERS = {
    "clarabel": with_clarabel,
    "ecos": with_ecos,
    "scs": with_scs,
    "piqp": by_tangents(piqp_rows),
    "highs": by_tangents(highs_rows),
    "osqp": by_tangents(osqp_rows),
}
