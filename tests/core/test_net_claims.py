"""The claims on nets: every joint is looked at, the worst place is found and named, other claims take one window."""

import json
import re
from dataclasses import replace

import numpy as np
import pytest

from qovr_core import Document, Formulation, Knots, build_patch
from qovr_core.edits import Direction, extract_window, set_points
from qovr_core.files import write_document
from qovr_core.geometry.knots import KnotTable
from qovr_core.laboratory import joint_claims
from qovr_core.laboratory.claims import CLAIMS
from qovr_core.laboratory.jumps import JointPlace
from qovr_core.laboratory.verify import Ground, Verdict, decide, verify
from support.command import qovr, refused

INTERPOLATING, DOUBLE_SUM = Formulation.INTERPOLATING, Formulation.DOUBLE_SUM
ALONG = np.linspace(0, 1, 401)
R, S, U, T = range(4)


def net_of(m, n, seed):
    rng = np.random.default_rng(seed)
    y, x = np.mgrid[: 2 * m + 3, : 2 * n + 3].astype(float)
    return np.stack([x, y, 0 * x], axis=-1) + rng.uniform(-0.4, 0.4, (*x.shape, 3))


def random_knots(curves, windows, seed):
    return np.random.default_rng(seed).uniform(0.2, 0.8, (curves, windows, 4))


def smooth_knots(curves, windows, seed):
    """Knots of smooth joints: u of a window and tau of a joint are shared, the outer r and t and all s are free."""
    knots, shared = random_knots(curves, windows, seed), random_knots(2, windows, seed + 1)[0]
    knots[:, :, U] = shared[:, U]
    knots[:, :-1, T] = shared[:-1, T]
    knots[:, 1:, R] = shared[:-1, T]
    return knots


def net_document(m, n, seed, knots=random_knots, **options):
    rows, columns = knots(2 * m + 3, n, seed + 10), knots(2 * n + 3, m, seed + 20)
    return Document(net_of(m, n, seed), KnotTable(rows), KnotTable(columns), INTERPOLATING, (41, 41), **options)


def sides(document, across, along=0):
    """Yield every joint in one window along it: name, window, both patches, and a derivative on both sides."""
    patch = build_patch(document)
    m, n = document.windows
    for a, b in np.ndindex(m, n):
        here = patch.window(a, b)
        if b < n - (not document.is_closed(Direction.ROWS)):
            after = patch.window(a, (b + 1) % n)
            left, right = (side.derivative([u], ALONG, across, along)[0] for side, u in ((here, 1.0), (after, 0.0)))
            yield f"u-joint {b}|{(b + 1) % n}", (a, b), (here, after), left, right
        if a < m - (not document.is_closed(Direction.COLUMNS)):
            after = patch.window((a + 1) % m, b)
            left, right = (side.derivative(ALONG, [v], along, across)[:, 0] for side, v in ((here, 1.0), (after, 0.0)))
            yield f"v-joint {a}|{(a + 1) % m}", (a, b), (here, after), left, right


def largest_jump(document, order):
    """Return the largest jump as part of the larger patch's size, and where it is, by looking at every joint."""
    found = []
    for name, window, patches, left, right in sides(document, order):
        jumps = np.linalg.norm(left - right, axis=-1)
        size = max(np.ptp(patch.coefficients, axis=(0, 1, 2, 3)).max() for patch in patches)
        found.append((jumps.max() / size, name, window, ALONG[jumps.argmax()]))
    return max(found)


MEASURES = ((0, joint_claims.c0), (1, joint_claims.c1), (2, joint_claims.c2))


@pytest.mark.parametrize(("m", "n", "seed"), [(2, 2, 1), (1, 3, 2), (3, 1, 3), (3, 4, 4)])
@pytest.mark.parametrize("formulation", [INTERPOLATING, DOUBLE_SUM], ids=str)
def test_the_worst_place_is_found_and_named(m, n, seed, formulation):
    document = replace(net_document(m, n, seed), formulation=formulation)
    for order, measure in MEASURES:
        measured = measure(document)
        if order == 0 and formulation is INTERPOLATING:
            assert measured.holds
            continue
        value, name, (a, b), at = largest_jump(document, order)
        assert measured.value == pytest.approx(value, rel=1e-4)
        assert (measured.place.window, measured.place.at) == ((a, b), pytest.approx(at, abs=0.01))
        along = "v" if name.startswith("u") else "u"
        assert f"largest at the {name} at {along} = {measured.place.at:.2f} of window ({a}, {b})" in measured.note


def test_one_joint_that_is_not_smooth_is_the_place():
    rows, columns = (np.full((curves, windows, 4), 0.5) for curves, windows in ((9, 4), (11, 3)))
    net = net_of(3, 4, 5)
    smooth = Document(net, KnotTable(rows), KnotTable(columns), INTERPOLATING)
    for measure in (joint_claims.c0, joint_claims.c1, joint_claims.g1):
        assert measure(smooth).holds
    rows[4, 1, T] = 0.4
    broken = Document(net, KnotTable(rows), KnotTable(columns), INTERPOLATING)
    assert joint_claims.c0(broken).holds
    for measure in (joint_claims.c1, joint_claims.g1):
        measured = measure(broken)
        assert not measured.holds
        assert "u-joint 1|2" in measured.note
        assert measured.place.parameters == (1.0, measured.place.at)
        assert measured.place.after == 2
    assert not joint_claims.JOINTS_ARE_SMOOTH.is_met(broken)


@pytest.mark.parametrize(("m", "n", "seed"), [(2, 2, 1), (1, 4, 2), (6, 5, 3), (5, 6, 4)])
def test_smooth_joints_have_one_tangent_plane_and_no_jump_in_the_net_s_parameter(m, n, seed):
    document = net_document(m, n, seed, smooth_knots)
    assert joint_claims.JOINTS_ARE_SMOOTH.is_met(document)
    found = joint_claims.joint_jumps(document)
    assert found.by_order[0].is_rounding
    assert found.in_net.is_rounding
    assert found.in_net.value < 1e-12
    assert found.planes.is_rounding
    assert found.planes.value < 1e-9
    assert not found.by_order[1].is_rounding
    assert "in the net's own parameter no jump" in joint_claims.c1(document).note
    for claim, verdict in (("C0", Verdict.TRUE), ("G1", Verdict.TRUE_IF)):
        finding = decide(CLAIMS[claim], document, INTERPOLATING)
        assert (finding.verdict, finding.ground, finding.here.holds) == (verdict, Ground.PROVED, True)


def test_the_angle_is_that_between_the_normals():
    document = net_document(2, 3, 6)
    angles = []
    for (*_, left, right), (*_, along_left, along_right) in zip(sides(document, 1), sides(document, 0, 1), strict=True):
        normals = [np.cross(left, along_left), np.cross(right, along_right)]
        before, after = (normal / np.linalg.norm(normal, axis=-1, keepdims=True) for normal in normals)
        angles.append(np.degrees(np.arccos(np.clip((before * after).sum(axis=-1), -1, 1))).max())
    assert joint_claims.g1(document).value == pytest.approx(max(angles), rel=1e-3)


def closed_net(n, rows):
    """Return a net that closes along u: its last three columns are the first."""
    points = net_of(2, n, 7)
    turn = np.arange(2 * n + 3) / (2 * n) * 2 * np.pi
    points[..., 0] = 10 * np.cos(turn)
    points[..., 1] = 10 * np.sin(turn)
    points[..., 2] += np.arange(7)[:, None]
    points[:, -3:] = points[:, :3]
    return Document(points, KnotTable(rows), Knots(), INTERPOLATING, (41, 41), closed=("u",))


def test_the_seam_of_a_closed_net_is_a_joint():
    halves = np.full((7, 4, 4), 0.5)
    smooth = joint_claims.joint_jumps(closed_net(4, halves))
    assert smooth.by_order[1].is_rounding
    assert smooth.planes.is_rounding
    halves[3, 3, T] = 0.3
    sharp = joint_claims.joint_jumps(closed_net(4, halves))
    assert sharp.by_order[0].is_rounding
    for jump in (sharp.by_order[1], sharp.in_net, sharp.planes):
        assert not jump.is_rounding
        assert str(jump.place).startswith("u-joint 3|0 at v = ")


def test_where_c1_is_claimed_it_holds():
    net = net_of(3, 2, 8)
    for knots in (Knots(), Knots(r=0.4, s=0.3, u=0.6, t=0.4)):
        document = Document(net, knots, knots, INTERPOLATING)
        assert joint_claims.KNOTS_CROSS_ALIKE.is_met(document)
        assert joint_claims.c1(document).holds
    assert not joint_claims.KNOTS_CROSS_ALIKE.is_met(Document(net, Knots(r=0.4, t=0.4), Knots(), INTERPOLATING))


def test_a_net_without_a_jump_of_the_second_derivative_is_its_own_example():
    i, j = np.indices((7, 9))
    affine = Document(np.stack([j + i, i - j / 3, 2 * i + j], axis=-1).astype(float), formulation=INTERPOLATING)
    measured = joint_claims.c2(affine)
    assert not measured.holds
    assert measured.example is affine
    assert measured.note == "yet this net has none"
    moved = affine.control_points.copy()
    moved[3, 0, 2] += 1
    measured = joint_claims.c2(set_points(affine, moved))
    assert measured.holds
    assert measured.example.windows == (1, 1)
    assert "yet nets exist" in measured.note


def test_other_claims_are_measured_on_the_window_that_is_asked_for():
    document = net_document(2, 3, 9)
    window = (1, 2)
    of_window = {
        (finding.claim.name, finding.formulation): finding for finding in verify(extract_window(document, window))
    }
    for finding in verify(document, window):
        other = of_window[finding.claim.name, finding.formulation]
        if finding.claim.is_of_joints:
            assert finding.here.place is not None
        else:
            assert (finding.here.value, finding.here.note) == (other.here.value, other.here.note)
        assert (finding.verdict, finding.condition, finding.ground) == (other.verdict, other.condition, other.ground)
    c0 = decide(CLAIMS["C0"], document, DOUBLE_SUM)
    assert c0.counterexample == replace(document, formulation=DOUBLE_SUM)


def test_verdicts_on_a_net_do_not_depend_on_its_size():
    document = net_document(2, 2, 10)
    for scale in (1e-9, 1e9):
        scaled = set_points(document, scale * document.control_points)
        for name in ("C0", "C1", "G1", "C2"):
            one, other = (decide(CLAIMS[name], each, INTERPOLATING) for each in (document, scaled))
            assert (one.verdict, one.here.holds, one.here.note) == (other.verdict, other.here.holds, other.here.note)


def test_a_point_where_everything_meets_has_no_plane():
    point = Document(np.ones((7, 7, 3)), formulation=INTERPOLATING)
    for measure in (joint_claims.c0, joint_claims.c1, joint_claims.g1):
        measured = measure(point)
        assert (measured.value, measured.holds) == (0.0, True)


def test_places_are_named_by_the_window_before_the_joint():
    place = JointPlace(Direction.COLUMNS, (1, 0), 2, 0.25)
    assert str(place) == "v-joint 1|2 at u = 0.25 of window (1, 0)"
    assert place.parameters == (0.25, 1.0)
    assert JointPlace(Direction.COLUMNS, (1, 0), 2, 0.2).nearest_point == (5, 1)
    assert JointPlace(Direction.ROWS, (1, 2), 3, 0.6).nearest_point == (4, 7)
    assert JointPlace(Direction.ROWS, (1, 2), 3, 0.9).nearest_point == (5, 7)


# --- qovr verify ------------------------------------------------------------------------------------------------------


@pytest.fixture
def folder(tmp_path):
    write_document(net_document(2, 3, 11), tmp_path / "net.qovr")
    return tmp_path


def test_the_command_names_place_and_window(folder):
    run = qovr("verify", "net.qovr", "--window", "1,2", cwd=folder)
    assert (run.code, run.err) == (0, "")
    assert run.out.startswith(
        "Claims about neighbours are measured at every joint of the net, others on window (1, 2).\n"
    )
    assert re.search(r"largest at the [uv]-joint \d\|\d at [uv] = \d\.\d\d of window \(\d, \d\)", run.out)
    found = json.loads(qovr("verify", "net.qovr", "--window", "1,2", "--json", cwd=folder).out)
    assert found["window"] == [1, 2]
    places = {claim["id"]: claim["formulations"]["interpolating"].get("place") for claim in found["claims"]}
    assert {claim for claim, place in places.items() if place} == {"C0", "C1", "G1", "C2"}
    assert set(places["G1"]["window"]) <= {0, 1, 2}
    assert max(places["G1"]["parameters"]) == 1.0


def test_a_window_that_is_not_there_is_refused(folder):
    assert "0,0 to 1,2" in refused(qovr("verify", "net.qovr", "--window", "2,0", cwd=folder))
    assert "A,B" in refused(qovr("verify", "net.qovr", "--window", "2", cwd=folder))
